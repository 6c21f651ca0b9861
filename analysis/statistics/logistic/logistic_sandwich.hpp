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

/// Of every coefficient. Where the parts would be too large the jackknife refits without them; what
/// else is no `clustered_fit` has by default CR1 of the fit's own standard errors, and nothing,
/// with the condition no_robust_variance, by another way that was asked for.
[[nodiscard]] ClusterInferences cluster_inferences(const LogisticInput& input,
                                                   const LogisticFit& fit,
                                                   std::optional<ClusterInference> inference,
                                                   const WildOptions& options);

}  // namespace tcert::statistics
