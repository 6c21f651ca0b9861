#pragma once
/// \file
/// What the checks of a trial's rays need of every reading, in one pass over its ticks.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "datasets/ticks.hpp"

namespace tcert {

/// What the readings of one ray were at the fresh ticks. Most rays of most trials need no second
/// look: their extremes say that all is well.
struct RayScan {
  std::size_t known = 0;  ///< Readings that are not missing.
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  double largest_force_n = -std::numeric_limits<double>::infinity();
};

struct TrialScan {
  std::vector<RayScan> rays;
  std::vector<std::uint32_t> fresh;  ///< Indices of the ticks that are not stale.
  std::span<const double> way_m;     ///< Of all ticks: see travelled_way().

  /// Metres up to the last fresh tick.
  [[nodiscard]] double last_way_m() const noexcept {
    return fresh.empty() ? 0.0 : way_m[fresh.back()];
  }
};

/// Keeps `way_m`. O(ticks x rays).
[[nodiscard]] TrialScan scan_rays(const TickTable& ticks, std::span<const double> way_m);

/// At how many fresh ticks `holds` is true of the reading of ray `k`: a second look.
template <class Predicate>
[[nodiscard]] std::size_t count_readings(const TickTable& ticks,
                                         const TrialScan& scan,
                                         std::size_t k,
                                         Predicate holds) {
  return static_cast<std::size_t>(std::ranges::count_if(
      scan.fresh, [&](std::uint32_t i) { return holds(ticks.readings[i * ticks.rays + k]); }));
}

}  // namespace tcert
