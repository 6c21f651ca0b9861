#pragma once
/// \file
/// Sums over the rows of a group at the nodes of the rule. Internal to intercept_likelihood.cpp.

#include <statistics/glmm/intercept_mode.hpp>

namespace tcert::statistics {

/// The group's log-likelihood: the log of the sum over the nodes, which the scratch gets with their
/// shares. NaN if a linear predictor exceeds 300. O(rows nodes).
[[nodiscard]] double value_at_nodes(const InterceptGroup& group,
                                    double theta,
                                    const HermiteRule& rule,
                                    const InterceptMode& mode,
                                    InterceptScratch& scratch);

/// Sums over rows at each node: of residuals, and for the Hessian of weights and of both times x.
/// \pre value_at_nodes() was there.
void sum_at_nodes(const InterceptGroup& group, bool with_x, InterceptScratch& scratch);

}  // namespace tcert::statistics
