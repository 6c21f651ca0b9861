#pragma once
/// \file
/// Partial log-likelihood, score and information by Efron's, Breslow's and the exact rule for ties.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/cox/cox_risk_pass.hpp>
#include <statistics/cox/cox_rows.hpp>
#include <vector>

namespace tcert::statistics {

/// With respect to the coefficients of the scaled columns.
struct CoxDerivatives {
  double loglik = 0.0;
  Eigen::VectorXd score;        ///< p.
  Eigen::MatrixXd information;  ///< p x p, symmetric.
};

/// What Efron's rule needs of d tied events: the k-th of them, k = 0..d-1, sees the events with
/// weight g = 1 - k/d beside the others. Sums over k of g^i / z^j, with z the k-th denominator.
/// Breslow's rule is the same sum with g = 1 throughout.
struct TieSums {
  double log_z = 0.0;  ///< Sum of log z.
  double a1 = 0.0;     ///< 1 / z.
  double b1 = 0.0;     ///< g / z.
  double a2 = 0.0;     ///< 1 / z^2.
  double b2 = 0.0;     ///< g / z^2.
  double c2 = 0.0;     ///< g^2 / z^2.
};

/// `others` and `events`: the sums of risk of the two. \pre d > 0. O(d), O(1) with Breslow.
[[nodiscard]] TieSums tie_sums(double others, double events, std::size_t d, Ties ties) noexcept;

/// Adds one event time's part to score (p) and information (lower triangle by rows) and returns
/// what it takes from the log-likelihood beside its events' own predictors. O(p (d + p)).
double add_risk_set(const CoxRows& rows,
                    const RiskSet& set,
                    Ties ties,
                    std::vector<double>& score,
                    std::vector<double>& information);

/// \pre some event. O(m p^2) with Efron or Breslow.
[[nodiscard]] CoxDerivatives cox_derivatives(const CoxRows& rows,
                                             const Eigen::VectorXd& beta,
                                             Ties ties);

/// By the recursion of Gail, Lubin and Rubinstein (1981) and Howard (1972), in probabilities: it
/// neither overflows nor cancels. O(m d p^2) a time with d > 1 events and m rows at risk.
[[nodiscard]] CoxDerivatives exact_derivatives(const CoxRows& rows, const Eigen::VectorXd& beta);

}  // namespace tcert::statistics
