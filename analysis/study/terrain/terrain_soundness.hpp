#pragma once
/// \file
/// Random terrains with a known Lipschitz constant: what the certified rules hold safe that is not.

#include <cstddef>
#include <cstdint>
#include <table/row_text.hpp>
#include <terrain/rules.hpp>

namespace tcert::terrain::study {

/// What the planner is told of every terrain of a set.
struct Telling {
  double told = 1.0;           ///< Times the true Lipschitz constant.
  bool trusted = false;        ///< The model's band is believed too,
  double beta = Rules{}.beta;  ///< which is sqrt(beta) sd wide.
};

/// What came of one terrain.
struct TerrainOutcome {
  bool unsafe_cells = false;   ///< An unsafe cell was held safe at some step.
  bool unsafe_visits = false;  ///< The robot stepped onto one.
  bool contradicted = false;   ///< Measurements raised the constant.
  bool reached = false;
  bool not_reachable = false;  ///< Ended with no cell left to measure, or all explored.
  std::uint64_t samples = 0;
};

void row_cells(auto& row, table::Is<TerrainOutcome> auto& one) {
  row(one.unsafe_cells, one.unsafe_visits, one.contradicted);
  row(one.reached, one.not_reachable, one.samples);
}

/// Terrain number `number`, of 48 x 36 cells, length scale 8, threshold at its mean, start and goal
/// drawn from safe cells.
[[nodiscard]] TerrainOutcome explore_terrain(const Telling& telling,
                                             std::uint64_t seed,
                                             std::uint64_t number);

/// What a set of terrains comes to, one after the other.
struct Soundness {
  std::size_t terrains = 0;
  std::size_t with_unsafe_cells = 0;
  std::size_t with_unsafe_visits = 0;
  std::size_t contradicted = 0;
  std::size_t reached = 0;
  std::size_t not_reachable = 0;
  std::size_t limit = 0;  ///< Stopped by the limit of steps, or stranded.
  std::uint64_t samples = 0;

  void add(const TerrainOutcome& one);
  [[nodiscard]] double mean_samples() const noexcept;
};

}  // namespace tcert::terrain::study
