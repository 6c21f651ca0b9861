#include <statistics/logistic/logistic_checks.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tcert::statistics {

void check_lengths(const LogisticInput& input, double level) {
  const Eigen::Index rows = input.design.rows();
  const auto fits = [&](const Eigen::VectorXd& v) { return v.size() == 0 || v.size() == rows; };
  const auto columns = static_cast<std::size_t>(input.design.cols());
  if (input.successes.size() != rows || !fits(input.trials) || !fits(input.weights) ||
      !fits(input.offset) || input.columns.size() != columns || input.term_of.size() != columns ||
      (input.cluster && input.cluster->rows() != static_cast<std::size_t>(rows))) {
    throw std::invalid_argument("logistic regression: lengths differ");
  }
  if (!(level > 0.0 && level < 1.0)) {
    throw std::invalid_argument("logistic regression: level must be in (0, 1)");
  }
  for (Eigen::Index i = 0; i < rows; ++i) {
    const double trials = input.trials.size() > 0 ? input.trials[i] : 1.0;
    if (!(input.successes[i] >= 0.0 && input.successes[i] <= trials)) {
      throw std::invalid_argument("logistic regression: successes must be in [0, trials]");
    }
  }
}

void add_value_conditions(const LogisticInput& input, Conditions& conditions) {
  for (Eigen::Index j = 0; j < input.design.cols(); ++j) {
    if (!input.design.col(j).allFinite()) {
      conditions.push_back({ConditionKind::infinite_value,
                            ConditionSeverity::error,
                            input.columns[static_cast<std::size_t>(j)],
                            ""});
    }
  }
  if (!input.offset.allFinite()) {
    conditions.push_back({ConditionKind::infinite_value, ConditionSeverity::error, "offset", ""});
  }
  if (!input.weights.allFinite() || (input.weights.array() < 0.0).any()) {
    conditions.push_back(
        {ConditionKind::bad_weight, ConditionSeverity::error, "", "negative or infinite"});
  }
}

bool has_intercept(const LogisticInput& input) {
  return std::find(input.term_of.begin(), input.term_of.end(), 0U) != input.term_of.end();
}

void add_rank_conditions(const LogisticInput& input,
                         const LogisticProblem& problem,
                         Conditions& conditions) {
  for (const std::size_t j : problem.space.dropped) {
    const Eigen::VectorXd values = input.design(problem.used, static_cast<Eigen::Index>(j));
    const bool constant = (values.array() == values[0]).all();
    const auto kind = constant ? ConditionKind::constant_column : ConditionKind::collinear_column;
    const bool known =
        std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
          return condition.kind == kind && condition.column == input.columns[j];
        });
    if (!known) {
      conditions.push_back({kind,
                            ConditionSeverity::warning,
                            input.columns[j],
                            constant ? fmt::format("it is {} in every row", values[0]) : ""});
    }
  }
}

}  // namespace tcert::statistics
