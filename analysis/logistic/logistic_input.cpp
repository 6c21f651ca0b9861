#include <stdexcept>
#include <string>

#include "analysis/logistic/logistic.hpp"
#include "analysis/model/frame_checks.hpp"
#include "datasets/csv_write.hpp"

namespace tcert {
namespace {

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

std::optional<Condition> first_not_binary(const ModelFrame& frame,
                                          const std::vector<double>& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != 0.0 && values[i] != 1.0) {
      std::string found;
      append_number(found, values[i]);
      return Condition{ConditionKind::not_binary,
                       ConditionSeverity::error,
                       frame.response,
                       "found " + found + " in " + place_of(frame, i)};
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

}  // namespace tcert
