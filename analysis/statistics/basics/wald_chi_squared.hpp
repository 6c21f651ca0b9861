#pragma once
/// \file
/// Quadratic forms that are tests: Wald's, that several coefficients are 0, and score tests.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <statistics/basics/chi_square.hpp>

namespace tcert::statistics {

/// b' V^-1 b, never negative, on as many degrees of freedom as there are coefficients. Empty if
/// there is none, an entry is not finite, or V cannot be inverted, as a robust one of fewer
/// clusters than coefficients. Scales do not matter. O(k^3).
[[nodiscard]] std::optional<ChiSquareTest> wald_test(const Eigen::VectorXd& estimates,
                                                     const Eigen::MatrixXd& covariance);

/// The same with the p of Hotelling's T^2 for a covariance that is made of `clusters` units: T^2
/// (G - k) / (k (G - 1)) by F with k and G - k degrees of freedom. Empty also for G <= k.
[[nodiscard]] std::optional<ChiSquareTest> hotelling_test(const Eigen::VectorXd& estimates,
                                                          const Eigen::MatrixXd& covariance,
                                                          std::size_t clusters);

}  // namespace tcert::statistics
