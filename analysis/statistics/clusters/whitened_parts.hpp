#pragma once
/// \file
/// Parts of a sandwich from scores and information as a model has them.

#include <Eigen/Core>
#include <optional>
#include <statistics/clusters/sandwich_parts.hpp>
#include <vector>

namespace tcert::statistics {

/// `information` (r x r) is that of the fit; `scores` r x G; `by_cluster` the information of each
/// cluster, scaled so that they add up to the fit's; `functionals` r x p. Empty if an information
/// is singular. O(G r^3).
[[nodiscard]] std::optional<SandwichParts> whitened_parts(
    const Eigen::MatrixXd& information,
    const Eigen::MatrixXd& scores,
    const std::vector<Eigen::MatrixXd>& by_cluster,
    const Eigen::MatrixXd& functionals);

}  // namespace tcert::statistics
