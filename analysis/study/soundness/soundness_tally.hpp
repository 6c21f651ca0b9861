#pragma once
/// \file
/// What the outcomes of worlds come to, world by world, so that none of them need be kept.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "analysis/study/soundness/soundness.hpp"

namespace tcert::study {

/// What the outcomes of one method say of all worlds.
struct SoundnessSummary {
  std::size_t worlds = 0;
  std::uint64_t ticks = 0;
  std::size_t issued = 0;
  std::size_t spurious = 0;       ///< Issued although T <= 0.
  std::size_t untraversable = 0;  ///< Worlds with T <= 0.
  std::size_t violations = 0;     ///< Worlds with T_t > T at some tick.
  std::uint64_t violating_ticks = 0;
  double largest_excess_m = 0.0;             ///< Largest T_t - T where above 0; else 0.
  std::optional<std::uint64_t> worst_world;  ///< The first world in which it is so large.

  /// \param number of the world among those of its kind.
  void add(const WorldOutcome& world, const SoundnessOutcome& outcome, std::uint64_t number);

  /// One-sided 95 % Clopper-Pearson bound of the rate of violated worlds; 1 without a world.
  [[nodiscard]] double violation_bound() const;
};

/// T_upper - T_t at the end of the runs that reached G, by how much of the world they explored.
struct Tightness {
  WorldFamily family = WorldFamily::gates;
  unsigned explored = 0;
  unsigned lanes = 0;
  std::size_t worlds = 0;
  double median_m = 0.0;
  double p90_m = 0.0;
};

/// Of worlds of one kind, by method. Memory: 8 bytes a world and method for the quantiles.
class SoundnessTally {
 public:
  /// \param families that have summaries of their own.
  SoundnessTally(std::size_t methods, std::span<const WorldFamily> families);

  /// World `number` of its kind. \pre an outcome a method.
  void add(const WorldOutcome& world, std::uint64_t number);

  [[nodiscard]] std::size_t worlds() const noexcept { return worlds_; }
  [[nodiscard]] const SoundnessSummary& of_all(std::size_t method) const {
    return of_all_.at(method);
  }
  /// \pre `family` is one of those of the constructor.
  [[nodiscard]] const SoundnessSummary& of(WorldFamily family, std::size_t method) const {
    return of_family_.at(family).at(method);
  }
  [[nodiscard]] std::vector<Tightness> tightness(std::size_t method) const;

 private:
  using Place = std::tuple<WorldFamily, unsigned, unsigned>;

  std::size_t worlds_ = 0;
  std::vector<SoundnessSummary> of_all_;
  std::map<WorldFamily, std::vector<SoundnessSummary>> of_family_;
  std::vector<std::map<Place, std::vector<double>>> gaps_;  ///< By method.
};

}  // namespace tcert::study
