#include <statistics/model/model_frame.hpp>

#include <algorithm>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/frame_checks.hpp>
#include <statistics/model/frame_parts.hpp>

namespace tcert::statistics {
namespace {

Eigen::VectorXd as_vector(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void take_offset(const EvaluatedFormula& all, ModelFrame& frame) {
  for (const NamedVariable& offset : all.offsets) {
    const std::vector<double> values = on_rows(offset.value.numbers, frame.rows);
    check_finite(values, to_string(offset.expression), frame);
    const Eigen::VectorXd column = as_vector(values);
    frame.offset = frame.offset ? Eigen::VectorXd(*frame.offset + column) : column;
  }
}

void take_weights(const EvaluatedFormula& all, ModelFrame& frame) {
  for (const NamedVariable& weights : all.weights) {
    const std::vector<double> values = on_rows(weights.value.numbers, frame.rows);
    check_weights(values, to_string(weights.expression), frame);
    frame.weights = as_vector(values);
  }
}

void add_column(std::vector<std::string>& columns, const std::string& name) {
  if (!name.empty() && std::find(columns.begin(), columns.end(), name) == columns.end()) {
    columns.push_back(name);
  }
}

}  // namespace

ModelFrame model_frame(const Formula& formula,
                       const table::DataTable& table,
                       const FrameOptions& options) {
  EvaluatedFormula all = evaluate_formula(formula, table, options);
  ModelFrame frame;
  frame.formula = formula.text;
  frame.response = to_string(formula.response);
  take_rows(all, frame);
  take_outcome(all, frame);
  take_right_side(all, frame);
  take_strata(all, frame);
  if (!all.clusters.empty()) {
    frame.cluster = on_rows(all.clusters.front().value.factor, frame.rows);
  }
  take_random_effects(all, frame);
  take_offset(all, frame);
  take_weights(all, frame);
  return frame;
}

std::vector<std::string> columns_of(const Formula& formula, const FrameOptions& options) {
  std::vector<std::string> columns = formula.columns();
  add_column(columns, options.weights);
  add_column(columns, options.cluster);
  add_column(columns, options.strata);
  return columns;
}

void require_binary(ModelFrame& frame) {
  if (std::holds_alternative<SurvivalOutcome>(frame.outcome)) {
    throw FormulaError("'" + frame.response + "': needs an outcome of 0 and 1, not Surv()");
  }
  const auto* const numbers = std::get_if<NumberOutcome>(&frame.outcome);
  if (numbers == nullptr) {
    return;
  }
  check_binary(numbers->values, frame.response, frame);
  CountOutcome counts;
  counts.successes = numbers->values;
  counts.trials.assign(counts.successes.size(), 1.0);
  frame.outcome = std::move(counts);
}

}  // namespace tcert::statistics
