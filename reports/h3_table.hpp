#pragma once
/// \file
/// The table of H3: speed gained and successes kept, by speed law, beta and lighting.

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "reports/fit/fit_report.hpp"
#include "reports/table.hpp"

namespace tcert {

/// As a document: one row a lighting, law and beta (rates of advance, gain, share of the gap,
/// successes lost and retained, stalls, the Pareto front); one row a lighting (the two algorithms
/// ungated, the gap between them, latency); all intervals and the options.
[[nodiscard]] FitReport h3_report(const study::H3Table& h3);

}  // namespace tcert
