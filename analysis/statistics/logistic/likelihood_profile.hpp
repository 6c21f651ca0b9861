#pragma once
/// \file
/// Where a likelihood, maximised over all other directions, has fallen by as much as an interval
/// allows: what plain and penalised profiles share.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <statistics/basics/interval.hpp>

namespace tcert::statistics {

/// A maximum, free or constrained, of a (penalised) log-likelihood along an orthonormal basis.
struct ProfilePoint {
  Eigen::VectorXd coefficients;
  double value = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;  ///< Positive definite; about minus the Hessian.
};

/// Maximises over start + span(subspace); empty if that does not converge.
using ConstrainedMaximum = std::function<std::optional<ProfilePoint>(
    const Eigen::VectorXd& start, const Eigen::MatrixXd& subspace)>;

/// Orthonormal columns that span what is orthogonal to the columns of `functionals`.
/// \pre these are linearly independent.
[[nodiscard]] Eigen::MatrixXd orthogonal_complement(const Eigen::MatrixXd& functionals);

/// The value of functional' coefficients below (`sign` -1) or above the maximum at which twice the
/// drop from `maximum` is the chi-squared quantile of `level` (one degree of freedom), to 1e-10 of
/// its root. Empty if it is not found. About 8 maximisations.
[[nodiscard]] std::optional<double> profile_end(const ProfilePoint& maximum,
                                                const Eigen::VectorXd& functional,
                                                const ConstrainedMaximum& maximise,
                                                double level,
                                                double sign);

/// Both ends. Empty if one is not found.
[[nodiscard]] std::optional<Interval> profile_interval(const ProfilePoint& maximum,
                                                       const Eigen::VectorXd& functional,
                                                       const ConstrainedMaximum& maximise,
                                                       double level);

}  // namespace tcert::statistics
