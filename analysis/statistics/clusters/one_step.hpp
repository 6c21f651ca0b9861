#pragma once
/// \file
/// Coefficients without each cluster, without refits.

#include <Eigen/Core>
#include <statistics/clusters/sandwich_parts.hpp>

namespace tcert::statistics {

/// How the coefficients change when a cluster is left out, by one Newton step from the estimates of
/// all: -(I - L' A_g L)^-1 L' u_g, r x G in the coordinates of the parts; `functionals`' times it
/// are the changes of the coefficients. The linearised jackknife CV3L of MacKinnon, Nielsen and
/// Webb (2024, "Cluster-robust jackknife and bootstrap inference for logistic regression models");
/// with single rows as clusters Pregibon's (1981) one-step. The error is of second order in a
/// cluster's share: with a dozen failures standard errors are some 7 % too small. NaN where a
/// cluster alone determines a direction. O(G r^3).
[[nodiscard]] Eigen::MatrixXd one_step_changes(const SandwichParts& parts);

}  // namespace tcert::statistics
