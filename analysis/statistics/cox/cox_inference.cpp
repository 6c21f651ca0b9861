#include <statistics/cox/cox_inference.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/basics/wald_chi_squared.hpp>
#include <statistics/cox/cox_robust.hpp>
#include <statistics/cox/cox_runaway.hpp>
#include <string>
#include <utility>
#include <vector>

namespace tcert::statistics {
namespace {

void name_missing_variance(const std::string& column, std::string detail, CoxFit& fit) {
  fit.conditions.push_back(
      {ConditionKind::no_robust_variance, ConditionSeverity::warning, column, std::move(detail)});
}

/// \pre `fit.vcov` is still that of the scaled columns: the same quadratic forms, well conditioned.
void add_tests(const CoxMaximum& maximum, CoxFit& fit) {
  const std::vector<Eigen::Index> ranked = ranked_columns(maximum.columns);
  fit.likelihood_ratio =
      chi_square_test(std::max(0.0, 2.0 * (*fit.loglik - *fit.loglik_null)), fit.df);
  if (ranked.empty()) {
    fit.score = fit.wald = chi_square_test(0.0, 0);
    return;
  }
  fit.score = wald_test(maximum.null.score(ranked), maximum.null.information(ranked, ranked));
  const Eigen::MatrixXd variance = fit.vcov(ranked, ranked);
  fit.wald = wald_test(maximum.beta(ranked), variance);
  if (fit.robust && !fit.wald && variance.allFinite()) {
    const std::string clusters =
        fit.clusters == 0 ? "" : std::to_string(fit.clusters) + " clusters and ";
    name_missing_variance("",
                          clusters + std::to_string(fit.df) +
                              " columns: that of all columns together is singular, so there is no "
                              "Wald test of them",
                          fit);
  }
}

/// A variance that is rounding of 0, as of a column that differs within a single cluster: the score
/// residuals of all clusters add up to 0.
void forget_rounded_variances(const CoxData& data, const Eigen::MatrixXd& model, CoxFit& fit) {
  constexpr double kRounding = 1e-16;
  for (Eigen::Index j = 0; j < fit.vcov.cols(); ++j) {
    if (fit.vcov(j, j) <= kRounding * model(j, j)) {
      name_missing_variance(
          data.columns[static_cast<std::size_t>(j)],
          "the clusters' residuals of the column are 0, as if a single one of them told of it",
          fit);
      for (Eigen::MatrixXd* const variance : {&fit.vcov, &fit.limit_vcov}) {
        variance->row(j).setConstant(std::nan(""));
        variance->col(j).setConstant(std::nan(""));
      }
    }
  }
}

/// Sets `fit.limit_vcov` and `fit.vcov`, of the scaled columns.
void add_robust_variance(const CoxData& data,
                         const CoxRows& rows,
                         const CoxMaximum& maximum,
                         const Eigen::MatrixXd& inverse,
                         CoxFit& fit) {
  const table::Factor* const cluster = data.cluster ? &*data.cluster : nullptr;
  if (cluster != nullptr) {
    fit.clusters = count_codes(cluster->codes);
    add_cluster_conditions(fit.clusters, "", fit.conditions, fit.df, "", kTooFewClusters);
    if (fit.clusters < 2) {
      fit.vcov.setConstant(std::nan(""));
      fit.limit_vcov.setConstant(std::nan(""));
      return;
    }
  }
  const std::vector<Eigen::Index> ranked = ranked_columns(maximum.columns);
  const ClusterScores scores = cluster_scores(rows, maximum.beta, fit.ties, cluster);
  fit.limit_vcov = inverse * scores.products * inverse;
  fit.vcov = with_missing(fit.limit_vcov, maximum);
  forget_rounded_variances(data, inverse, fit);
  if (!ranked.empty()) {
    const ClusterScores null =
        cluster_scores(rows, Eigen::VectorXd::Zero(maximum.beta.size()), fit.ties, cluster);
    // With as many columns as clusters the form is the number of clusters, whatever the data.
    if (fit.clusters == 0 || fit.clusters > ranked.size()) {
      fit.robust_score = wald_test(null.total(ranked), null.products(ranked, ranked));
    }
  }
}

/// Estimates that have run away are known no longer: NaN among the variances.
void withhold_runaways(const CoxData& data,
                       const CoxRows& rows,
                       const CoxMaximum& maximum,
                       CoxFit& fit) {
  const std::vector<bool> away = cox_runaways(data, rows, maximum, fit.model_vcov, fit.events);
  for (std::size_t j = 0; j < away.size(); ++j) {
    if (!away[j]) {
      continue;
    }
    const auto at = static_cast<Eigen::Index>(j);
    fit.conditions.push_back(
        {ConditionKind::near_separation,
         ConditionSeverity::warning,
         data.columns[j],
         fmt::format("a log hazard ratio of {:.3g} with a standard error of {:.3g}",
                     fit.beta(at),
                     std::sqrt(fit.model_vcov(at, at)) / rows.scale(at))});
    for (Eigen::MatrixXd* const variances : {&fit.model_vcov, &fit.vcov}) {
      variances->row(at).setConstant(std::nan(""));
      variances->col(at).setConstant(std::nan(""));
    }
  }
}

/// \pre the variances of `fit` are still those of the scaled columns: in others they may leave the
/// range of numbers.
void add_coefficients(const CoxData& data,
                      const CoxRows& rows,
                      const CoxMaximum& maximum,
                      CoxFit& fit) {
  const double factor = normal_factor(fit.level);
  for (std::size_t j = 0; j < data.columns.size(); ++j) {
    const auto at = static_cast<Eigen::Index>(j);
    CoxCoefficient coefficient;
    coefficient.column = data.columns[j];
    coefficient.is_infinite = maximum.columns[j] == ColumnState::infinite;
    if (!std::isnan(fit.model_vcov(at, at))) {
      const double estimate = fit.beta(at);
      coefficient.estimate = estimate;
      coefficient.hazard_ratio = std::exp(estimate);
      const double unit = rows.scale(at);
      coefficient.model_se = std::sqrt(fit.model_vcov(at, at)) / unit;
      if (fit.robust && !std::isnan(fit.vcov(at, at))) {
        coefficient.robust_se = std::sqrt(fit.vcov(at, at)) / unit;
      }
      const double scaled_se = std::sqrt((fit.robust ? fit.vcov : fit.model_vcov)(at, at));
      const std::optional<double> se = fit.robust ? coefficient.robust_se : coefficient.model_se;
      if (se && scaled_se > 0.0) {
        coefficient.z = maximum.beta(at) / scaled_se;
        coefficient.p_value = normal_p_value(*coefficient.z, Alternative::two_sided);
        coefficient.interval =
            Interval{estimate - factor * *se, estimate + factor * *se, fit.level};
      }
    }
    fit.coefficients.push_back(std::move(coefficient));
  }
}

}  // namespace

void add_cox_inference(const CoxData& data,
                       const CoxRows& rows,
                       const CoxMaximum& maximum,
                       CoxFit& fit) {
  const Eigen::MatrixXd limit = limit_inverse(maximum);
  const Eigen::MatrixXd inverse = with_missing(limit, maximum);
  fit.vcov = inverse;
  fit.limit_vcov = limit;
  if (fit.robust) {
    add_robust_variance(data, rows, maximum, limit, fit);
  }
  add_tests(maximum, fit);
  fit.model_vcov = inverse;
  withhold_runaways(data, rows, maximum, fit);
  add_coefficients(data, rows, maximum, fit);
  const Eigen::VectorXd unit = rows.scale.cwiseInverse();
  fit.model_vcov = unit.asDiagonal() * fit.model_vcov * unit.asDiagonal();
  fit.vcov = unit.asDiagonal() * fit.vcov * unit.asDiagonal();
  fit.limit_vcov = unit.asDiagonal() * fit.limit_vcov * unit.asDiagonal();
  fit.limit_model_vcov = unit.asDiagonal() * limit * unit.asDiagonal();
  const auto df = static_cast<double>(fit.df);
  fit.aic = -2.0 * *fit.loglik + 2.0 * df;
  fit.bic = -2.0 * *fit.loglik + df * std::log(static_cast<double>(fit.events));
}

}  // namespace tcert::statistics
