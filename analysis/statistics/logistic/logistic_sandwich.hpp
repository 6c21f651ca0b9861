#pragma once
/// \file
/// A clustered logistic regression as `cluster_inferences` asks for it.

#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/logistic/logistic.hpp>

namespace tcert::statistics {

/// Empty without clusters, without a finite fit (under separation), and where the parts would be
/// too large. The functions refer to `input`, which must outlive them. `left_out` has O(G) refits.
[[nodiscard]] std::optional<ClusteredFit> clustered_fit(const LogisticInput& input,
                                                        const LogisticFit& fit);

/// Of every coefficient. By CR1 of the fit's own standard errors where it is no `clustered_fit`.
[[nodiscard]] ClusterInferences cluster_inferences(const LogisticInput& input,
                                                   const LogisticFit& fit,
                                                   std::optional<ClusterInference> inference,
                                                   const WildOptions& options);

}  // namespace tcert::statistics
