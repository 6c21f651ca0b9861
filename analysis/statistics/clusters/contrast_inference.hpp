#pragma once
/// \file
/// Sums of coefficients by the inference of their clusters.

#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/model/pairwise.hpp>

namespace tcert::statistics {

/// Each row of `weights` (k x p): by the covariance of `of` and clusters - 1 degrees of freedom; of
/// CR2 by the sums' own of Satterthwaite, which need the parts of `fit`. The wild bootstrap is of
/// single coefficients: nothing.
[[nodiscard]] std::vector<CoefficientSum> cluster_sums(
    const std::optional<ClusteredFit>& fit,
    const ClusterInferences& of,
    std::span<const std::optional<double>> coefficients,
    std::size_t clusters,
    const Eigen::MatrixXd& weights);

}  // namespace tcert::statistics
