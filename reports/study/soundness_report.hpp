#pragma once
/// \file
/// How often, how far and how tightly the certificate bounds the truth of random worlds.

#include <cstdint>
#include <vector>

#include "analysis/study/soundness/soundness.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// What was certified, and in which worlds.
struct SoundnessRuns {
  std::vector<study::SoundnessMethod> mixed_methods;
  std::vector<study::WorldOutcome> mixed;
  std::vector<study::SoundnessMethod> turn_methods;
  std::vector<study::WorldOutcome> turns;
  std::uint64_t seed = 1;
};

/// Tables soundness (by worlds and method) and tightness.
[[nodiscard]] FitReport soundness_report(const SoundnessRuns& runs);

}  // namespace tcert
