#pragma once
/// \file
/// A clustered Cox model as `cluster_inferences` asks for it.

#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/cox/cox.hpp>

namespace tcert::statistics {

/// A cluster's information is the predictable variation of its score residuals, the sum over its
/// rows of the risk score times the integral of (x - mean)(x - mean)' by the baseline hazard: with
/// it the corrections of a `glm` carry over to the Cox model as its equivalent Poisson regression
/// (Whitehead 1980), the baseline hazard taken as known. Empty without clusters, without a finite
/// fit, with exact ties, and where the parts would be too large. The functions refer to `data`,
/// which must outlive them. `left_out` has O(G) refits.
[[nodiscard]] std::optional<ClusteredFit> clustered_fit(const CoxData& data, const CoxFit& fit);

/// Of every coefficient. Where the parts would be too large the jackknife refits without them; what
/// else is no `clustered_fit` has by default CR1 of the fit's own standard errors, and nothing,
/// with the condition no_robust_variance, by another way that was asked for.
[[nodiscard]] ClusterInferences cluster_inferences(const CoxData& data,
                                                   const CoxFit& fit,
                                                   std::optional<ClusterInference> inference,
                                                   const WildOptions& options);

}  // namespace tcert::statistics
