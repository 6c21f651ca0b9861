#pragma once
/// \file
/// The binomial log-likelihood with Jeffreys' penalty (Firth 1993): half the logarithm of the
/// determinant of the information is added, which keeps every estimate finite.

#include <Eigen/Core>
#include <statistics/logistic/binomial_likelihood.hpp>

namespace tcert::statistics {

struct FirthLikelihood {
  /// log-likelihood + log det(X' W X) / 2, without the binomial coefficients of the counts; minus
  /// infinity where the information cannot be inverted.
  double value = 0.0;
  double log_likelihood = 0.0;  ///< Without the penalty.
  /// X' (y - m mu + h (1/2 - mu)), h the diagonal of the hat matrix: of `value`.
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;  ///< X' W X.
  Eigen::MatrixXd curvature;    ///< Minus the Hessian of `value`; need not be positive definite.
};

/// At linear predictor X beta + offset. With w' = w (1 - 2 mu), w'' = w (1 - 6 mu (1 - mu)) and
/// q_i = x_i' I^-1 x_i the Hessian of the penalty is
///   (1/2) X' diag(w'' q) X - (1/2) [tr(I^-1 M_r I^-1 M_s)]_rs,  M_r = X' diag(w' x_r) X.
/// O(rows columns^3).
[[nodiscard]] FirthLikelihood firth_likelihood(const Eigen::MatrixXd& design,
                                               const BinomialRows& rows,
                                               const Eigen::VectorXd& coefficients);

}  // namespace tcert::statistics
