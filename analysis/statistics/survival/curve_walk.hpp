#pragma once
/// \file
/// The points of one survival curve. Internal to survival_curve.cpp.

#include <cstdint>
#include <span>
#include <statistics/survival/survival_curve.hpp>
#include <vector>

namespace tcert::statistics {

/// The rows of one group, by their stops and (with late entry) their starts.
struct CurveRows {
  const SurvivalOutcome* outcome = nullptr;
  const CurveOptions* options = nullptr;
  std::span<const std::uint32_t> stops;
  std::span<const std::uint32_t> starts;
  bool robust = false;

  [[nodiscard]] double weight(std::uint32_t row) const {
    return options->weights.empty() ? 1.0 : options->weights[row];
  }
};

/// O(rows), given the orders. \pre `points` is empty.
void walk_curve(const CurveRows& rows, std::vector<SurvivalPoint>& points);

}  // namespace tcert::statistics
