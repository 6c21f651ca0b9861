#pragma once
/// \file
/// One group's share of the likelihood of a model with a single random intercept, with first and
/// second derivatives by theta and along the basis. Internal to intercept_likelihood.cpp.
///
/// With f(u) = sum of y eta - m log(1 + exp eta) - u^2 / 2, eta = x gamma + o + theta u, mode u0, h
/// = -f''(u0), s = h^(-1/2), nodes z_k and weights w_k:
///     l = log sum_k w_k exp(f(t_k) + z_k^2 / 2) + log s,   t_k = u0 + s z_k
/// (Pinheiro and Bates, 1995); a single node is Laplace's approximation. Both u0 and s move with
/// the parameters: f_u(u0; p) = 0 gives du0/dp = f_up / h, and differentiating once more the second
/// derivatives.

#include <Eigen/Core>
#include <statistics/glmm/hermite_rule.hpp>
#include <statistics/glmm/mixed_likelihood.hpp>
#include <vector>

namespace tcert::statistics {

/// Rows of one group, columns contiguous within a row.
struct InterceptGroup {
  const double* basis = nullptr;  ///< rows x columns.
  const double* successes = nullptr;
  const double* trials = nullptr;
  const double* fixed = nullptr;  ///< x gamma + o.
  const double* odds = nullptr;   ///< exp(fixed).
  Eigen::Index rows = 0;
  Eigen::Index columns = 0;
  bool unit_trials = false;
};

/// A sum over groups, and what rows will add to it: gradient along the basis = sum of slope * x,
/// Hessian along it = sum of curvature * x x', both over rows.
struct InterceptSum {
  double value = 0.0;
  Eigen::VectorXd gradient;  ///< By theta and, still without rows, along the basis.
  Eigen::MatrixXd hessian;   ///< Lower triangle.
};

/// Room for the work on one group after the other.
struct InterceptScratch {
  // One entry a node.
  std::vector<double> t, factor, product, log_density, share, residual, weight;
  // columns x nodes, nodes contiguous: sums of residual * x and of weight * x.
  std::vector<double> residual_x, weight_x;
  // One entry a row, at the mode: the variance of y and its derivatives by eta.
  std::vector<double> w0, w1, w2;
  // One entry a parameter.
  Eigen::VectorXd mode_by, h_by, log_s_by, h_by_u, w0_x, w1_x, w2_x, d, mean_d, cross0, cross1;
};

/// Adds the group to `sum`; writes a slope and (for the Hessian) a curvature a row. `mode` holds a
/// guess of u0 and gets u0. False if a linear predictor exceeds 300. O(rows nodes), for the Hessian
/// O(rows nodes columns).
[[nodiscard]] bool add_intercept_group(const InterceptGroup& group,
                                       double theta,
                                       const HermiteRule& rule,
                                       Derivatives wanted,
                                       double& mode,
                                       InterceptScratch& scratch,
                                       double* slope,
                                       double* curvature,
                                       InterceptSum& sum);

}  // namespace tcert::statistics
