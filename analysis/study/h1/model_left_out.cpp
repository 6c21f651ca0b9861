#include "analysis/study/h1/model_left_out.hpp"

#include <cmath>
#include <functional>
#include <optional>
#include <statistics/clusters/one_step.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/logistic/logistic_sandwich.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <table/not_a_number.hpp>

namespace tcert::study {
namespace {

using StatisticOf = std::function<statistics::Statistic(const Eigen::VectorXd& predictor)>;

double value_of(const statistics::Statistic& statistic) {
  double value = table::kNaN;
  statistic.make_kernel()(std::vector<std::uint32_t>(statistic.rows, 1), {&value, 1});
  return value;
}

ModelLeftOut left_out(const Eigen::MatrixXd& design,
                      const std::optional<statistics::ClusteredFit>& fit,
                      const StatisticOf& statistic_of,
                      const statistics::ResamplingPlan& plan) {
  if (!fit) {
    const std::vector<double> none(plan.units(), table::kNaN);
    return {none, none};
  }
  const statistics::SandwichParts& parts = fit->parts;
  const Eigen::MatrixXd changes = statistics::one_step_changes(parts);
  // A column without an estimate has no part in the predictor.
  const Eigen::VectorXd beta = parts.estimates.array().isNaN().select(0.0, parts.estimates);
  // Columns: the coefficients' move by a standard error along each coordinate.
  const Eigen::MatrixXd moves =
      parts.functionals.array().isNaN().select(0.0, parts.functionals).transpose();
  Eigen::RowVectorXd slope(moves.cols());
  for (Eigen::Index j = 0; j < moves.cols(); ++j) {
    slope(j) = 0.5 * (value_of(statistic_of(design * (beta + moves.col(j)))) -
                      value_of(statistic_of(design * (beta - moves.col(j)))));
  }
  ModelLeftOut result;
  result.score = statistics::leave_one_out(statistic_of(design * beta), plan).front();
  for (std::size_t unit = 0; unit < plan.units(); ++unit) {
    const auto change = changes.col(static_cast<Eigen::Index>(unit));
    result.score[unit] += slope * change;
    result.added.push_back(parts.estimates(Eigen::last) + moves.bottomRows<1>() * change);
  }
  return result;
}

table::Factor as_factor(const statistics::ResamplingPlan& plan) {
  table::Factor cluster;
  cluster.levels.resize(plan.units());
  for (std::size_t row = 0; row < plan.rows(); ++row) {
    cluster.codes.push_back(plan.unit_of(row));
  }
  return cluster;
}

std::span<const double> as_span(const Eigen::VectorXd& values) {
  return {values.data(), static_cast<std::size_t>(values.size())};
}

}  // namespace

ModelLeftOut logistic_left_out(const H1Data& data,
                               const H1Model& model,
                               const statistics::ResamplingPlan& plan) {
  statistics::LogisticInput input = model.logistic();
  input.cluster = as_factor(plan);
  return left_out(
      input.design,
      statistics::clustered_fit(input, statistics::fit_logistic(input)),
      [&](const Eigen::VectorXd& predictor) {
        const statistics::Score score{as_span(predictor)};
        return statistics::auc_statistic({&score, 1}, data.success);
      },
      plan);
}

ModelLeftOut cox_left_out(const H1Data& data,
                          const H1Model& model,
                          const statistics::ResamplingPlan& plan) {
  statistics::CoxData cox = model.cox();
  cox.cluster = as_factor(plan);
  return left_out(
      cox.design,
      statistics::clustered_fit(cox, statistics::fit_cox(cox)),
      [&](const Eigen::VectorXd& predictor) {
        const statistics::Predictor by{
            "", as_span(predictor), statistics::LargerMeans::shorter_time};
        return statistics::concordance_statistic(*data.censored, {&by, 1});
      },
      plan);
}

}  // namespace tcert::study
