#pragma once
/// \file
/// H1 and H2 as they are asked for.

#include <string>

#include "analysis/study/h1/hypothesis_h1.hpp"
#include "analysis/study/h2/hypothesis_h2.hpp"
#include "cli/runs/hypotheses.hpp"

namespace tcert::cli {

/// \throws UsageError unless it is expanded, percentile or bca.
[[nodiscard]] statistics::BootstrapMethod interval_method(const std::string& name);

/// \throws UsageError for a value out of range.
[[nodiscard]] study::H1Options h1_options(const HypothesesRequest& request);

/// The same trials and the first predictor, by groups. \throws UsageError likewise, or if baselines
/// are given.
[[nodiscard]] study::H2Options h2_options(const HypothesesRequest& request);

}  // namespace tcert::cli
