#include "datasets/values/check_speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tcert/geometry.hpp>
#include <vector>

namespace tcert {
namespace {

constexpr std::int64_t kLongestWindowNs = 500'000'000;
constexpr std::int64_t kWindows = 40;  // and more, in a log of any unit of time
constexpr std::size_t kLeastWindows = 10;
constexpr double kFastestMps = 5.0;
constexpr double kTimesCommanded = 10.0;
constexpr double kNearCommanded = 3.0;
constexpr double kLeastCommandMps = 0.01;

struct Speeds {
  std::vector<double> driven_mps;
  std::vector<double> commanded_mps;  // at the same ticks, where known
};

Speeds speeds_of(const TickTable& ticks) {
  Speeds speeds;
  bool begun = false;
  std::size_t from = 0;
  const std::int64_t window_ns =
      std::min(kLongestWindowNs, (ticks.time_ns.back() - ticks.time_ns.front()) / kWindows);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    begun = begun && ticks.segment_start[i] == 0;
    if (ticks.stale[i] != 0 || (begun && ticks.time_ns[i] - ticks.time_ns[from] < window_ns)) {
      continue;
    }
    if (begun) {
      const double seconds = 1e-9 * static_cast<double>(ticks.time_ns[i] - ticks.time_ns[from]);
      speeds.driven_mps.push_back(distance(ticks.poses[from].position, ticks.poses[i].position) /
                                  seconds);
      if (i < ticks.speed_cmd_mps.size() && !std::isnan(ticks.speed_cmd_mps[i])) {
        speeds.commanded_mps.push_back(std::abs(ticks.speed_cmd_mps[i]));
      }
    }
    begun = true;
    from = i;
  }
  return speeds;
}

/// \pre not empty.
double middle_of(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

const char* likely_unit_of_poses(double times) noexcept {
  return times >= 30.0 && times < 300.0     ? "centimetres?"
         : times >= 300.0 && times < 3000.0 ? "millimetres, or another unit of time?"
                                            : "another unit of length or of time?";
}

}  // namespace

std::optional<ValueFinding> check_speed(const TickTable& ticks) {
  if (ticks.size() < kLeastWindows) {
    return std::nullopt;
  }
  Speeds speeds = speeds_of(ticks);
  if (speeds.driven_mps.size() < kLeastWindows) {
    return std::nullopt;
  }
  const double driven_mps = middle_of(speeds.driven_mps);
  const double commanded_mps =
      speeds.commanded_mps.size() >= kLeastWindows ? middle_of(speeds.commanded_mps) : 0.0;
  const bool commanded = commanded_mps >= kLeastCommandMps;
  const bool beyond_command = commanded && driven_mps > kTimesCommanded * commanded_mps;
  const bool as_commanded = commanded && driven_mps <= kNearCommanded * commanded_mps;
  if (!beyond_command && (driven_mps <= kFastestMps || as_commanded)) {
    return std::nullopt;
  }
  std::string found = fmt::format("a median speed of {:.3g} m/s", driven_mps);
  if (commanded) {
    found += fmt::format(", commanded {:.3g}", commanded_mps);
  }
  return value_finding(ValueKind::speed,
                       "x_m, y_m",
                       std::move(found),
                       std::string("metres, and times in seconds: ") +
                           (commanded ? likely_unit_of_poses(driven_mps / commanded_mps)
                                      : "millimetres, centimetres, or another unit of time?"));
}

}  // namespace tcert
