#pragma once
/// \file
/// A clustered logistic regression as `cluster_estimates` asks for it.

#include <optional>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/logistic/logistic.hpp>

namespace tcert::statistics {

/// Empty without clusters, without a finite fit (under separation), and where the parts would be
/// too large. The functions refer to `input`, which must outlive them. `left_out` has O(G) refits.
[[nodiscard]] std::optional<ClusteredFit> clustered_fit(const LogisticInput& input,
                                                        const LogisticFit& fit);

}  // namespace tcert::statistics
