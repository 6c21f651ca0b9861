#pragma once
/// \file
/// Quadratic forms that are tests: Wald's, that several coefficients are 0, and score tests.

#include <Eigen/Core>
#include <optional>
#include <statistics/basics/chi_square.hpp>

namespace tcert::statistics {

/// b' V^-1 b, never negative, on as many degrees of freedom as there are coefficients. Empty if
/// there is none, an entry is not finite, or V cannot be inverted, as a robust one of fewer
/// clusters than coefficients. Scales do not matter. O(k^3).
[[nodiscard]] std::optional<ChiSquareTest> wald_test(const Eigen::VectorXd& estimates,
                                                     const Eigen::MatrixXd& covariance);

}  // namespace tcert::statistics
