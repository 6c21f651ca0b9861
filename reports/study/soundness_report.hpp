#pragma once
/// \file
/// How often, how far and how tightly the certificate bounds the truth of random worlds.

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/study/soundness/soundness_tally.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Worlds of one kind, and what was certified in them.
struct SoundnessWorlds {
  std::string name;
  std::vector<WorldFamily> families;  ///< That have rows of their own, if they are several.
  std::vector<study::SoundnessMethod> methods;
  study::SoundnessTally tally{methods.size(), families};
};

struct SoundnessRuns {
  std::vector<SoundnessWorlds> kinds;
  std::uint64_t seed = 1;
};

/// Tables soundness (by worlds and method) and tightness.
[[nodiscard]] FitReport soundness_report(const SoundnessRuns& runs);

}  // namespace tcert
