#pragma once
/// \file
/// Random terrains with a known Lipschitz constant: what the certified rules hold safe that is not.

#include <cstddef>
#include <cstdint>
#include <terrain/rules.hpp>

namespace tcert::terrain::study {

struct Soundness {
  std::size_t terrains = 0;
  std::size_t with_unsafe_cells = 0;   ///< An unsafe cell was held safe at some step.
  std::size_t with_unsafe_visits = 0;  ///< The robot stepped onto one.
  std::size_t contradicted = 0;        ///< Measurements raised the constant.
  std::size_t reached = 0;
  std::size_t not_reachable = 0;  ///< Ended with no cell left to measure, or all explored.
  std::size_t limit = 0;          ///< Stopped by the limit of steps, or stranded.
  double mean_samples = 0.0;
};

/// `terrains` fields of 48 x 36 cells, length scale 8, threshold at their mean, start and goal
/// drawn from safe cells; the planner is told `factor` times the true constant and takes a band of
/// sqrt(beta) sd. Deterministic.
[[nodiscard]] Soundness soundness(std::size_t terrains,
                                  double factor,
                                  bool trust_model,
                                  std::uint64_t seed,
                                  double beta = Rules{}.beta);

}  // namespace tcert::terrain::study
