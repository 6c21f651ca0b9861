#pragma once
/// \file
/// The prospective H3 as tables and findings, the replay of the same trials beside it.

#include "analysis/study/driven/paired_arms.hpp"
#include "analysis/study/h3/hypothesis_h3.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// One row an arm: successes of both, lost and won worlds, difference, bound, p, the pairs that
/// would be needed, gain in rate of advance, and what `replays` say of the same law and beta; one
/// row an arm of collisions, force, stalls.
[[nodiscard]] FitReport h3_driven_report(const study::PairedArms& driven,
                                         const study::H3Table& replays);

}  // namespace tcert
