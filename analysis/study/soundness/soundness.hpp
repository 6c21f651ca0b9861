#pragma once
/// \file
/// How often, how far and how tightly the certificate bounds the truth, over random worlds.

#include <cstddef>
#include <cstdint>
#include <string>
#include <table/row_text.hpp>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <vector>
#include <witness/parameters.hpp>

#include "analysis/study/truth/clearance_value.hpp"
#include "datasets/random_worlds/random_world.hpp"

namespace tcert::study {

/// A way of certifying: a clearance reading or an ablation, on true or on logged ticks. A witness
/// is looked for at the end of the run, from ticks or from streams at their native rates.
struct SoundnessMethod {
  std::string name;
  CertificateParameters parameters;
  bool noise = false;
  witness::WitnessParameters witness{};  ///< Of clearance=witness.
  bool native_rates = false;             ///< The same.
};

/// radial, width, swept and A2, without noise and with; for the U-turns A3 in place of A2.
[[nodiscard]] std::vector<SoundnessMethod> mixed_methods();
[[nodiscard]] std::vector<SoundnessMethod> u_turn_methods();

/// Witnesses of ticks and of streams at native rates, without noise and with, and with a bound
/// taken off readings that have noise.
[[nodiscard]] std::vector<SoundnessMethod> witness_methods(double reading_bound_m = 0.01);

struct SoundnessOptions {
  std::uint64_t seed = 1;
  WorldFamily (*family)(std::uint64_t index) = mixed_family;  ///< Of the world of a number.
  bool driven = false;  ///< By policies through gated worlds in place of those.
};

/// One method in one world.
struct SoundnessOutcome {
  double certificate_m = ClearanceValue::kNoPath;  ///< T_t at the end.
  double excess_m = ClearanceValue::kNoPath;       ///< Largest T_t - T over the run.
  std::uint32_t violating_ticks = 0;               ///< Ticks with T_t > T.
  bool issued = false;
};

void row_cells(auto& row, table::Is<SoundnessOutcome> auto& outcome) {
  row(outcome.certificate_m, outcome.excess_m, outcome.violating_ticks, outcome.issued);
}

struct WorldOutcome {
  WorldFamily family = WorldFamily::gates;
  double truth_m = 0.0;  ///< T_upper by clearance; of a U-turn the exact T.
  double clearance_truth_m = 0.0;
  std::uint32_t ticks = 0;
  unsigned lanes = 1;
  unsigned explored = 1;
  bool reached = false;                    ///< The run got to its end.
  std::vector<SoundnessOutcome> outcomes;  ///< One per method.
};

void row_cells(auto& row, table::Is<WorldOutcome> auto& world) {
  row(world.family, world.truth_m, world.clearance_truth_m, world.ticks);
  row(world.lanes, world.explored, world.reached, world.outcomes);
}

/// T of the U-turn about a wall of thickness t between corridors of width w: the largest
/// min(2 (d - r_B), w + t/2 - d - R_min) over d <= w/2. To turn by half, a path of radius at least
/// r needs 2 r across, and the corridors leave 2 (w - d) + t between clearances d.
[[nodiscard]] double u_turn_value(double corridor_m, double wall_m, const Robot& robot) noexcept;

/// T_upper of a random world by clearance alone, in the width convention.
[[nodiscard]] double upper_value(const RandomWorld& drawn, const Robot& robot);

/// One world, certified by every method.
[[nodiscard]] WorldOutcome study_world(const std::vector<SoundnessMethod>& methods,
                                       const SoundnessOptions& options,
                                       std::uint64_t index);

}  // namespace tcert::study
