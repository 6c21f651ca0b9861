#pragma once
/// \file
/// What is settled about a driven trial before it is driven; its outcome is not.

#include <cstdint>
#include <optional>
#include <string>

#include "datasets/corpus/design.hpp"
#include "datasets/driven/drive_parameters.hpp"
#include "datasets/driven/driven_world.hpp"

namespace tcert {

struct DrivenDesign {
  std::uint64_t seed = 1;   ///< Of the noise, as `index`: trials that share both share all draws,
  std::uint64_t index = 0;  ///< whatever drives them.
  DrivenWorld world;
  DriveParameters parameters;
  std::string trial_id;   ///< Of its row, as the next.
  std::string algorithm;  ///< Name of the policy.
  Lighting lighting = Lighting::indoor;
  bool camera = false;        ///< The policy is given sightings.
  bool truth = false;         ///< Also keep what really happened: truth.csv.
  bool native_rates = false;  ///< Log every sample; else a logger keeps 20 a second of each stream.
  /// Every draw that has a side is drawn for the other side.
  bool mirrored = false;
  /// Of the noise alone: the same world and the same crash force, felt again. Empty: `seed`.
  std::optional<std::uint64_t> noise_seed{};
};

/// World k of a seed with the noise of (seed, k), in Indoor lighting, called as trial k.
/// \throws what draw_gated_world() throws.
[[nodiscard]] DrivenDesign design_driven(const DriveParameters& parameters,
                                         std::uint64_t seed,
                                         std::uint64_t index);

/// The mirrored world with mirrored draws.
[[nodiscard]] DrivenDesign mirrored(const DrivenDesign& design);

[[nodiscard]] std::uint64_t noise_seed(const DrivenDesign& design) noexcept;

/// \throws std::invalid_argument if a parameter is out of bounds, or S or G is missing.
void validate(const DrivenDesign& design);

}  // namespace tcert
