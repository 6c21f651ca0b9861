#include <statistics/logistic/separation_words.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace tcert::statistics {
namespace {

/// Outcomes of a group of rows.
struct Outcomes {
  bool success = false;
  bool failure = false;

  void add(const LogisticInput& input, Eigen::Index row) {
    const double trials = input.trials.size() > 0 ? input.trials[row] : 1.0;
    success = success || input.successes[row] > 0.0;
    failure = failure || input.successes[row] < trials;
  }
  [[nodiscard]] bool one_kind() const noexcept { return success != failure; }
};

std::string has(const LogisticInput& input, bool success) {
  if (input.trials.size() == 0 || input.trials.maxCoeff() <= 1.0) {
    return fmt::format("has {} = {}", input.response, success ? 1 : 0);
  }
  return success ? "has successes alone" : "has failures alone";
}

/// "f = c" for the column "fc" of term "f", "x:fc = 1" for others; "f at its reference level" if
/// `inside` is false and the term has levels.
std::string level_words(const LogisticInput& input, std::size_t column) {
  const std::string& name = input.columns[column];
  const std::size_t term = input.term_of[column];
  if (term > 0) {
    const std::string& factor = input.terms[term - 1];
    if (name.size() > factor.size() && name.compare(0, factor.size(), factor) == 0) {
      return factor + " = " + name.substr(factor.size());
    }
  }
  return name + " = 1";
}

bool is_dummy(const LogisticInput& input,
              const std::vector<Eigen::Index>& used,
              std::size_t column) {
  const auto values = input.design.col(static_cast<Eigen::Index>(column));
  return std::all_of(used.begin(), used.end(), [&](Eigen::Index row) {
    return values[row] == 0.0 || values[row] == 1.0;
  });
}

std::optional<std::string> dummy_words(const LogisticInput& input,
                                       const std::vector<Eigen::Index>& used,
                                       std::size_t column) {
  Outcomes inside;
  Outcomes reference;  // rows where all columns of the term are 0
  for (const Eigen::Index row : used) {
    if (input.design(row, static_cast<Eigen::Index>(column)) == 1.0) {
      inside.add(input, row);
      continue;
    }
    bool all_zero = true;
    for (std::size_t j = 0; j < input.columns.size(); ++j) {
      all_zero = all_zero && (input.term_of[j] != input.term_of[column] ||
                              input.design(row, static_cast<Eigen::Index>(j)) == 0.0);
    }
    if (all_zero) {
      reference.add(input, row);
    }
  }
  const std::size_t term = input.term_of[column];
  const std::string factor = term > 0 ? input.terms[term - 1] : input.columns[column];
  std::string words;
  if (inside.one_kind()) {
    words =
        fmt::format("every row with {} {}", level_words(input, column), has(input, inside.success));
  }
  if (reference.one_kind()) {
    words += fmt::format("{}every row with {} at its reference level {}",
                         words.empty() ? "" : ", ",
                         factor,
                         has(input, reference.success));
  }
  return words.empty() ? std::nullopt : std::optional(words);
}

/// The column in its own units.
double own_value(const LogisticInput& input, Eigen::Index row, std::size_t column) {
  if (column < input.own_units.size() &&
      static_cast<Eigen::Index>(input.own_units[column].size()) == input.design.rows()) {
    return input.own_units[column][static_cast<std::size_t>(row)];
  }
  return input.design(row, static_cast<Eigen::Index>(column));
}

std::optional<std::string> threshold_words(const LogisticInput& input,
                                           const std::vector<Eigen::Index>& used,
                                           std::size_t column) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double least_success = kInfinity;
  double most_success = -kInfinity;
  double least_failure = kInfinity;
  double most_failure = -kInfinity;
  for (const Eigen::Index row : used) {
    const double value = own_value(input, row, column);
    Outcomes outcome;
    outcome.add(input, row);
    if (outcome.success) {
      least_success = std::min(least_success, value);
      most_success = std::max(most_success, value);
    }
    if (outcome.failure) {
      least_failure = std::min(least_failure, value);
      most_failure = std::max(most_failure, value);
    }
  }
  const auto words = [&](double below, double above, bool success_above) {
    const bool apart = below < above;
    return fmt::format("every row with {0} {1} {2} {3}, every row with {0} {4} {5} {6}",
                       input.columns[column],
                       apart ? ">=" : ">",
                       above,
                       has(input, success_above),
                       apart ? "<=" : "<",
                       below,
                       has(input, !success_above));
  };
  if (least_success >= most_failure) {
    return words(most_failure, least_success, true);
  }
  if (least_failure >= most_success) {
    return words(most_success, least_failure, false);
  }
  return std::nullopt;
}

}  // namespace

std::string separation_words(const LogisticInput& input,
                             const std::vector<Eigen::Index>& used,
                             std::size_t column) {
  if (input.term_of[column] != 0) {
    const auto words = is_dummy(input, used, column) ? dummy_words(input, used, column)
                                                     : threshold_words(input, used, column);
    if (words) {
      return *words;
    }
  }
  return "together with other columns";
}

}  // namespace tcert::statistics
