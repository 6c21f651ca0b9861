#pragma once
/// \file
/// Sandwich variances over clusters with corrections for few of them.

#include <Eigen/Core>
#include <statistics/clusters/sandwich_parts.hpp>

namespace tcert::statistics {

/// The sum over clusters of M u u' M: no correction. p x p; NaN as the functionals.
[[nodiscard]] Eigen::MatrixXd sandwich_cr0(const SandwichParts& parts);

/// Each cluster's score is multiplied by (I - A_g M)^(-1/2), which makes the variance unbiased
/// where the model holds (Bell and McCaffrey 2002; `clubSandwich::vcovCR(type = "CR2")` of a
/// `glm`). Directions that a single cluster determines count as 0, as there. O(G r^3).
[[nodiscard]] Eigen::MatrixXd sandwich_cr2(const SandwichParts& parts);

/// Degrees of freedom of each coefficient's CR2 variance, by Satterthwaite's match of two moments
/// where the model holds (Pustejovsky and Tipton 2018; `coef_test(test = "Satterthwaite")`). p; NaN
/// as the functionals. O(G r^2 (r + p)).
[[nodiscard]] Eigen::VectorXd satterthwaite_df(const SandwichParts& parts);

}  // namespace tcert::statistics
