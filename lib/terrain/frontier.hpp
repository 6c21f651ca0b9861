#pragma once
/// \file
/// Which of the cells that could make the safe set grow to measure next, by what is expected there.

#include <cstdint>
#include <optional>
#include <span>
#include <terrain/confidence.hpp>
#include <terrain/rules.hpp>
#include <vector>

namespace tcert::terrain {

/// What a choice goes by; all spans and sets have one element a cell.
struct FrontierView {
  const Grid& grid;
  const Rules& rules;
  std::span<const double> mean;
  std::span<const double> variance;  ///< Times field_variance.
  double field_variance = 1.0;
  const Intervals& intervals;
  const CellSet& safe;
  const CellSet& blocked;                ///< Empty: nothing is.
  std::span<const std::int64_t> depth2;  ///< squared_depth(grid, safe).

  /// The mean, as far as the interval allows it.
  [[nodiscard]] double expected(std::size_t i) const;
  /// Of the disc that a measurement of the expected value certifies; 0 under `band`, which has
  /// none.
  [[nodiscard]] double expected_radius(std::size_t i) const;
};

/// The cell whose expected disc comes nearest to the goal, or grows most without one, the way to it
/// counted at rules.travel_weight. O(candidates).
[[nodiscard]] std::optional<Cell> look_ahead(const FrontierView& view,
                                             const std::vector<std::size_t>& candidates,
                                             std::optional<Cell> goal,
                                             Cell robot);

/// The first cell of the best sequence of rules.horizon expected measurements, each in the disc of
/// the one before it: a search by beams of 24, 16 directions each, under the belief that every
/// value is the expected one (against the zig-zag along frontiers, thesis 5.2.2). O(candidates log
/// candidates).
[[nodiscard]] std::optional<Cell> best_sequence(const FrontierView& view,
                                                const std::vector<std::size_t>& candidates,
                                                std::optional<Cell> goal,
                                                Cell robot);

/// The probability, by the model, that a measurement at member i of the safe set makes it grow:
/// that the disc reaches a cell outside (`certified`), that a neighbour outside is safe (`band`).
[[nodiscard]] double growth_probability(const FrontierView& view, std::size_t i);

/// After PSANE (Jiang, Qian and Liu, arXiv 2603.08905, 2026), of which the abstract is followed:
/// among the candidates that no other one beats in both the probability of growth and the cost,
/// |x - goal| + travel_weight |x - robot|, the largest growth_weight p - (1 - growth_weight) c,
/// both scaled to 0..1 over that front. O(candidates log candidates).
[[nodiscard]] std::optional<Cell> best_of_front(const FrontierView& view,
                                                const std::vector<std::size_t>& candidates,
                                                std::optional<Cell> goal,
                                                Cell robot);

}  // namespace tcert::terrain
