#include <statistics/calibration/out_of_fold.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <statistics/logistic/binomial_likelihood.hpp>
#include <statistics/logistic/logistic_refit.hpp>
#include <stdexcept>
#include <string>

namespace tcert::statistics {
namespace {

bool one_class(const LogisticInput& input, const std::vector<std::size_t>& rows) {
  std::size_t successes = 0;
  for (const std::size_t row : rows) {
    successes += input.successes[static_cast<Eigen::Index>(row)] == 1.0 ? 1 : 0;
  }
  return successes == 0 || successes == rows.size();
}

std::string why(Termination termination) {
  switch (termination) {
    case Termination::diverging:
      return "they are separated";
    case Termination::singular:
      return "they do not determine every coefficient";
    default:
      return std::string(to_string(termination));
  }
}

void name_fold(ConditionKind kind,
               std::size_t fold,
               const std::string& detail,
               Conditions& conditions) {
  conditions.push_back(
      {kind, ConditionSeverity::warning, "", "fold " + std::to_string(fold + 1) + ": " + detail});
}

}  // namespace

OutOfFold out_of_fold_probabilities(const LogisticInput& input, const Folds& folds) {
  if (input.trials.size() > 0 && (input.trials.array() != 1.0).any()) {
    throw std::invalid_argument("out-of-fold probabilities: one row, one trial");
  }
  if (input.weights.size() > 0) {
    throw std::invalid_argument("out-of-fold probabilities: without weights");
  }
  const auto rows = static_cast<std::size_t>(input.design.rows());
  OutOfFold result;
  result.probability.assign(rows, std::numeric_limits<double>::quiet_NaN());
  const LogisticRefit refit(input);
  for (std::size_t fold = 0; fold < folds.count; ++fold) {
    const std::vector<std::size_t> training = training_rows(folds, fold);
    if (one_class(input, training)) {
      name_fold(ConditionKind::one_class_fold, fold, "the rows outside it", result.conditions);
      continue;
    }
    std::vector<std::uint32_t> multiplicity(rows, 0);
    for (const std::size_t row : training) {
      multiplicity[row] = 1;
    }
    const LogisticReplicate fit = refit.fit(multiplicity);
    if (!fit.coefficients) {
      name_fold(ConditionKind::fold_without_fit, fold, why(fit.termination), result.conditions);
      continue;
    }
    const Eigen::VectorXd eta = refit.linear_predictor(*fit.coefficients);
    for (const std::size_t row : held_out_rows(folds, fold)) {
      result.probability[row] = inverse_logit(eta[static_cast<Eigen::Index>(row)]);
    }
  }
  return result;
}

}  // namespace tcert::statistics
