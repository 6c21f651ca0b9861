#pragma once
/// \file
/// The bottleneck micro-study (paper 3.4): 60 passes through gates about as wide as the body.

#include <cstdint>
#include <filesystem>

#include "datasets/corpus/simulated_trial.hpp"
#include "datasets/corpus/write_bundle.hpp"

namespace tcert {

inline constexpr std::uint64_t kGatePasses = 60;

/// Pass `index` < 60: gates of w_B - 3, -1.5, 0, +1.5 and +3 cm, 12 passes each, half of them from
/// either side of the gate, in random order, at one approach speed.
///
/// Declared: Pr(success) = logistic((w - w_B) / 8 mm), drawn per pass; a rigid body would give a
/// step. A pass that succeeds squeezes through, one that fails is held in the throat. Poses
/// are in the frame of the odometry, which begins at S: entering by the far side ("right") is the
/// same corridor turned round. Extra columns: true_margin_m, gate_width_m, entry_side. \pre index
/// < 60.
[[nodiscard]] SimulatedTrial simulate_gate_pass(std::uint64_t seed, std::uint64_t index);

/// Writes the 60 passes as a bundle of the corpus's format. \throws WriteError.
void simulate_micro_study(const std::filesystem::path& folder,
                          std::uint64_t seed,
                          const TrialProgress& progress = {},
                          bool replace = false);

}  // namespace tcert
