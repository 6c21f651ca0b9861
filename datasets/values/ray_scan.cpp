#include "datasets/values/ray_scan.hpp"

#include <cmath>

namespace tcert {
namespace {

/// So many ticks of all rays stay in the nearest cache while ray after ray is looked at.
constexpr std::size_t kTicksAtOnce = 64;

// Comparisons with a missing value are false, so that it counts nowhere.
void scan_ray(const TickTable& ticks,
              std::span<const std::uint32_t> fresh,
              std::size_t k,
              RayScan& scan) noexcept {
  RayScan found = scan;
  for (const std::uint32_t i : fresh) {
    const double value = ticks.readings[i * ticks.rays + k].value;
    const double force_n = ticks.readings[i * ticks.rays + k].fsr_n;
    found.known += std::isnan(value) ? 0 : 1;
    found.least = value < found.least ? value : found.least;
    found.largest = value > found.largest ? value : found.largest;
    found.largest_force_n = force_n > found.largest_force_n ? force_n : found.largest_force_n;
  }
  scan = found;
}

}  // namespace

TrialScan scan_rays(const TickTable& ticks, std::span<const double> way_m) {
  TrialScan scan;
  scan.way_m = way_m;
  scan.rays.resize(ticks.rays);
  scan.fresh.reserve(ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (ticks.stale[i] == 0) {
      scan.fresh.push_back(static_cast<std::uint32_t>(i));
    }
  }
  std::span<const std::uint32_t> rest(scan.fresh);
  while (!rest.empty()) {
    const auto now = rest.first(std::min(kTicksAtOnce, rest.size()));
    rest = rest.subspan(now.size());
    for (std::size_t k = 0; k < ticks.rays; ++k) {
      scan_ray(ticks, now, k, scan.rays[k]);
    }
  }
  return scan;
}

}  // namespace tcert
