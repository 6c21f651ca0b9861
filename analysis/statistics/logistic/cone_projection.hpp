#pragma once
/// \file
/// The point of a polyhedral cone that is nearest to a given one.

#include <Eigen/Core>
#include <optional>

namespace tcert::statistics {

/// The projection of `target` onto {d : rows * d >= 0}; rows have length 1. By Moreau it is what
/// non-negative least squares leaves of `target` after the best combination of -rows. Lawson and
/// Hanson's active-set method: exact up to rounding, O(rows columns) an iteration and usually few
/// times as many iterations as columns. A projection shorter than `smallest` is 0. Empty if it does
/// not end within 50 (columns + 10) iterations, which only rounding could bring about.
[[nodiscard]] std::optional<Eigen::VectorXd> project_on_cone(const Eigen::MatrixXd& rows,
                                                             const Eigen::VectorXd& target,
                                                             double smallest);

}  // namespace tcert::statistics
