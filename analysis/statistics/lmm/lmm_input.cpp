#include <statistics/lmm/lmm.hpp>
#include <statistics/model/formula.hpp>

namespace tcert::statistics {

LmmInput lmm_input(const ModelFrame& frame) {
  const auto* const numbers = std::get_if<NumberOutcome>(&frame.outcome);
  if (numbers == nullptr) {
    throw FormulaError("'" + frame.response +
                       "': a linear model needs a plain number, such as log(time_s)");
  }
  LmmInput input;
  input.design = frame.design;
  input.columns = frame.columns;
  input.response = frame.response;
  input.y = Eigen::Map<const Eigen::VectorXd>(numbers->values.data(),
                                              static_cast<Eigen::Index>(numbers->values.size()));
  input.random = frame.random_effects;
  input.conditions = frame.conditions;
  if (frame.weights) {
    input.weights = *frame.weights;
  }
  if (frame.offset) {
    input.offset = *frame.offset;
  }
  return input;
}

}  // namespace tcert::statistics
