#include <statistics/logistic/logistic.hpp>
#include <statistics/model/frame_checks.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <table/csv_write.hpp>
#include <table/trimmed.hpp>

namespace tcert::statistics {
namespace {

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// "cbind(k, n - k)" for the response "k/n"; in general words for another.
std::string counts_in_words(const std::string& response) {
  const std::size_t slash = response.find('/');
  const auto plain = [](const std::string& name) {
    return !name.empty() && name.find_first_of("/()+-*^:, ") == std::string::npos;
  };
  if (slash != std::string::npos) {
    const std::string k(table::trimmed(std::string_view(response).substr(0, slash)));
    const std::string n(table::trimmed(std::string_view(response).substr(slash + 1)));
    if (plain(k) && plain(n)) {
      return "cbind(" + k + ", " + n + " - " + k + ")";
    }
  }
  return "cbind(successes, failures)";
}

/// Shares of successes, which R takes with their numbers of trials as weights.
bool are_shares(const std::string& response, const std::vector<double>& values) {
  bool fraction = response.find('/') != std::string::npos;
  for (const double value : values) {
    if (!(value >= 0.0 && value <= 1.0)) {
      return response.find('/') != std::string::npos;
    }
    fraction = fraction || (value > 0.0 && value < 1.0);
  }
  return fraction;
}

std::optional<Condition> first_not_binary(const ModelFrame& frame,
                                          const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != 0.0 && values[i] != 1.0) {
      Condition condition{ConditionKind::not_binary,
                          ConditionSeverity::error,
                          frame.response,
                          "found " + table::number_text(values[i]) + " in " + place_of(frame, i)};
      if (are_shares(frame.response, values)) {
        condition.advice = "shares of successes are given by their counts: write '" +
                           counts_in_words(frame.response) + "', without --weights";
      }
      return condition;
    }
  }
  return std::nullopt;
}

}  // namespace

LogisticInput logistic_input(const ModelFrame& frame) {
  LogisticInput input;
  input.design = frame.design;
  input.columns = frame.columns;
  input.term_of = frame.term_of;
  input.terms = frame.terms;
  input.response = frame.response;
  input.cluster = frame.cluster;
  input.conditions = frame.conditions;
  if (frame.offset) {
    input.offset = *frame.offset;
  }
  if (frame.weights) {
    input.weights = *frame.weights;
  }
  if (const auto* const counts = std::get_if<CountOutcome>(&frame.outcome)) {
    input.successes = vector_of(counts->successes);
    input.trials = vector_of(counts->trials);
  } else if (const auto* const numbers = std::get_if<NumberOutcome>(&frame.outcome)) {
    input.successes = vector_of(numbers->values);
    if (auto condition = first_not_binary(frame, numbers->values)) {
      input.conditions.push_back(std::move(*condition));
    }
  } else {
    throw std::invalid_argument("logistic regression: the outcome is a survival time");
  }
  return input;
}

}  // namespace tcert::statistics
