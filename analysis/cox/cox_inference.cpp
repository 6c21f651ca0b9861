#include "analysis/cox/cox_inference.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/basics/few_clusters.hpp"
#include "analysis/basics/normal.hpp"
#include "analysis/cox/cox_robust.hpp"
#include "analysis/cox/cox_runaway.hpp"

namespace tcert {
namespace {

std::size_t distinct_clusters(const Factor& cluster) {
  std::vector<char> seen(cluster.levels.size(), 0);
  std::size_t count = 0;
  for (const std::uint32_t code : cluster.codes) {
    count += seen[code] == 0 ? 1U : 0U;
    seen[code] = 1;
  }
  return count;
}

/// u' matrix^-1 u.
double quadratic_form(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& u) {
  const Eigen::VectorXd solution = matrix.ldlt().solve(u);
  return u.dot(solution);
}

/// \pre `fit.vcov` is still that of the scaled columns: the same quadratic forms, well conditioned.
void add_tests(const CoxMaximum& maximum, CoxFit& fit) {
  const std::vector<Eigen::Index> ranked = ranked_columns(maximum.columns);
  fit.likelihood_ratio = chi_square_test(2.0 * (*fit.loglik - *fit.loglik_null), fit.df);
  if (ranked.empty()) {
    fit.score = fit.wald = chi_square_test(0.0, 0);
    return;
  }
  const Eigen::VectorXd score = maximum.null.score(ranked);
  const Eigen::MatrixXd information = maximum.null.information(ranked, ranked);
  fit.score = chi_square_test(quadratic_form(information, score), fit.df);
  const Eigen::MatrixXd variance = fit.vcov(ranked, ranked);
  if (variance.allFinite()) {
    const Eigen::VectorXd beta = maximum.beta(ranked);
    fit.wald = chi_square_test(quadratic_form(variance, beta), fit.df);
  }
}

void add_robust_variance(const CoxData& data,
                         const CoxRows& rows,
                         const CoxMaximum& maximum,
                         const Eigen::MatrixXd& inverse,
                         CoxFit& fit) {
  const Factor* const cluster = data.cluster ? &*data.cluster : nullptr;
  if (cluster != nullptr) {
    fit.clusters = distinct_clusters(*cluster);
    if (fit.clusters < 2) {
      fit.conditions.push_back({ConditionKind::one_cluster, ConditionSeverity::warning, {}, {}});
      fit.vcov.setConstant(std::nan(""));
      return;
    }
    if (auto few = few_clusters(fit.clusters, fit.df)) {
      fit.conditions.push_back(std::move(*few));
    }
  }
  const std::vector<Eigen::Index> ranked = ranked_columns(maximum.columns);
  const ClusterScores scores = cluster_scores(rows, maximum.beta, fit.ties, cluster);
  std::vector<Eigen::Index> known;
  for (const Eigen::Index j : ranked) {
    if (!std::isnan(inverse(j, j))) {
      known.push_back(j);
    }
  }
  fit.vcov.setConstant(std::nan(""));
  if (!known.empty()) {
    const Eigen::MatrixXd bread = inverse(known, known);
    const Eigen::MatrixXd filling = scores.products(known, known);
    const Eigen::MatrixXd sandwich = bread * filling * bread;
    fit.vcov(known, known) = sandwich;
  }
  if (!ranked.empty()) {
    const ClusterScores null =
        cluster_scores(rows, Eigen::VectorXd::Zero(maximum.beta.size()), fit.ties, cluster);
    const Eigen::MatrixXd products = null.products(ranked, ranked);
    const Eigen::VectorXd total = null.total(ranked);
    // Fewer clusters than columns leave no variance in some direction.
    if (fit.clusters == 0 || fit.clusters > ranked.size()) {
      fit.robust_score = chi_square_test(quadratic_form(products, total), fit.df);
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
  const Eigen::MatrixXd inverse = inverse_information(maximum);
  fit.vcov = inverse;
  if (fit.robust) {
    add_robust_variance(data, rows, maximum, inverse, fit);
  }
  add_tests(maximum, fit);
  fit.model_vcov = inverse;
  withhold_runaways(data, rows, maximum, fit);
  add_coefficients(data, rows, maximum, fit);
  const Eigen::VectorXd unit = rows.scale.cwiseInverse();
  fit.model_vcov = unit.asDiagonal() * fit.model_vcov * unit.asDiagonal();
  fit.vcov = unit.asDiagonal() * fit.vcov * unit.asDiagonal();
  const auto df = static_cast<double>(fit.df);
  fit.aic = -2.0 * *fit.loglik + 2.0 * df;
  fit.bic = -2.0 * *fit.loglik + df * std::log(static_cast<double>(fit.events));
}

}  // namespace tcert
