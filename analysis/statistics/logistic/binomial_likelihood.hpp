#pragma once
/// \file
/// The log-likelihood of successes out of trials under a logit link, with its derivatives.

#include <Eigen/Core>

namespace tcert::statistics {

/// Rows that a likelihood works on together: their columns fit into the first-level cache.
inline constexpr Eigen::Index kRowsAtOnce = 256;

/// One entry a row; case weights are multiplied in, so neither needs to be whole.
struct BinomialRows {
  Eigen::VectorXd successes;
  Eigen::VectorXd trials;  ///< At least `successes`.
  Eigen::VectorXd offset;  ///< Empty for none.
};

struct BinomialLikelihood {
  double log_likelihood = 0.0;  ///< Without the binomial coefficients of the counts.
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;  ///< Minus the Hessian: X' W X, both triangles.
  double largest_eta = 0.0;     ///< Largest |linear predictor| of a row with trials.
};

/// At linear predictor X beta + offset. O(rows columns^2); allocates nothing of the rows' length.
[[nodiscard]] BinomialLikelihood binomial_likelihood(const Eigen::MatrixXd& design,
                                                     const BinomialRows& rows,
                                                     const Eigen::VectorXd& coefficients);

/// 1 / (1 + exp(-eta)), without overflow.
[[nodiscard]] double inverse_logit(double eta) noexcept;

/// Sum of the logarithms of the binomial coefficients of `successes` out of `trials`, each times
/// its weight; an empty `weights` is 1.
[[nodiscard]] double log_binomial_coefficients(const Eigen::VectorXd& successes,
                                               const Eigen::VectorXd& trials,
                                               const Eigen::VectorXd& weights);

/// Log-likelihood (without coefficients) of the saturated model: each row's own proportion.
[[nodiscard]] double saturated_log_likelihood(const BinomialRows& rows);

}  // namespace tcert::statistics
