#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tcert/tracking_error.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr double kLoopPeriod = 0.02;
constexpr double kTickPeriod = 0.1;

void require_axis(std::string_view name, const std::vector<double>& knots) {
  bool good = !knots.empty() && knots.front() == 0.0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    good = good && knots[i] > knots[i - 1] && std::isfinite(knots[i]);
  }
  if (!good) {
    throw std::invalid_argument("tracking error: " + std::string(name) +
                                " must start at 0 and rise");
  }
}

/// Where a value lies between two knots.
struct Place {
  std::size_t low = 0;
  std::size_t high = 0;
  double share = 0.0;
  bool inside = false;
};

Place place_of(const std::vector<double>& knots, double value) noexcept {
  if (!(value >= 0.0 && value <= knots.back())) {
    return {};
  }
  const auto above = std::upper_bound(knots.begin(), knots.end(), value);
  const auto low = static_cast<std::size_t>(above - knots.begin()) - 1;
  if (above == knots.end()) {
    return {low, low, 0.0, true};
  }
  return {low, low + 1, (value - knots[low]) / (knots[low + 1] - knots[low]), true};
}

}  // namespace

TrackingErrorGrid declared_tracking_error() {
  TrackingErrorGrid grid{{0.0, 0.1, 0.25, 0.5}, {0.0, 1.0, 5.0}, {0.0, 1.0}, {}};
  for (const double speed : grid.speed_mps) {
    for (const double acceleration : grid.acceleration_mps2) {
      for (const double disturbance : grid.disturbance) {
        grid.radius_m.push_back(
            (1.0 + disturbance) *
            (speed * kLoopPeriod + 0.5 * acceleration * kTickPeriod * kTickPeriod));
      }
    }
  }
  return grid;
}

TrackingErrorTable::TrackingErrorTable(TrackingErrorGrid grid) : grid_(std::move(grid)) {
  require_axis("speed_mps", grid_.speed_mps);
  if (has_speed_left() && !grid_.acceleration_mps2.empty()) {
    throw std::invalid_argument(
        "tracking error: one of acceleration_mps2 and speed_left_mps, not both");
  }
  require_axis(has_speed_left() ? "speed_left_mps" : "acceleration_mps2", second_axis());
  if (grid_.hold_s.size() != grid_.speed_left_mps.size() ||
      !std::is_sorted(grid_.hold_s.begin(), grid_.hold_s.end()) ||
      !std::all_of(grid_.hold_s.begin(), grid_.hold_s.end(), [](double s) {
        return std::isfinite(s) && s >= 0.0;
      })) {
    throw std::invalid_argument(
        "tracking error: one hold_s for every speed_left_mps, which must not fall");
  }
  require_axis("disturbance", grid_.disturbance);
  const std::size_t speeds = grid_.speed_mps.size();
  const std::size_t second_knots = second_axis().size();
  const std::size_t disturbances = grid_.disturbance.size();
  if (grid_.radius_m.size() != speeds * second_knots * disturbances) {
    throw std::invalid_argument("tracking error: one radius_m for every knot of the grid");
  }
  for (std::size_t i = 0; i < speeds; ++i) {
    for (std::size_t j = 0; j < second_knots; ++j) {
      for (std::size_t k = 0; k < disturbances; ++k) {
        const double here = at(i, j, k);
        const bool good =
            std::isfinite(here) && here >= 0.0 && (i == 0 || here >= at(i - 1, j, k)) &&
            (j == 0 || here >= at(i, j - 1, k)) && (k == 0 || here >= at(i, j, k - 1));
        if (!good) {
          throw std::invalid_argument(
              "tracking error: radius_m must not be negative nor fall along an axis");
        }
      }
    }
  }
}

double TrackingErrorTable::at(std::size_t speed,
                              std::size_t second,
                              std::size_t disturbance) const noexcept {
  const std::size_t row = speed * second_axis().size() + second;
  return grid_.radius_m[row * grid_.disturbance.size() + disturbance];
}

double TrackingErrorTable::hold_s(double speed_mps) const noexcept {
  const Place place = place_of(grid_.speed_left_mps, speed_mps);
  return place.inside ? std::lerp(grid_.hold_s[place.low], grid_.hold_s[place.high], place.share)
                      : std::numeric_limits<double>::infinity();
}

double TrackingErrorTable::radius_m(double speed_mps,
                                    double second,
                                    double disturbance) const noexcept {
  const Place v = place_of(grid_.speed_mps, speed_mps);
  const Place a = place_of(second_axis(), second);
  const Place d = place_of(grid_.disturbance, disturbance);
  if (!v.inside || !a.inside || !d.inside) {
    return std::numeric_limits<double>::infinity();
  }
  // On a knot the value there is the answer, to the bit.
  const auto between = [](const Place& place, auto value_at) noexcept {
    const double low = value_at(place.low);
    return place.share > 0.0 ? std::lerp(low, value_at(place.high), place.share) : low;
  };
  return between(v, [&](std::size_t i) noexcept {
    return between(a, [&](std::size_t j) noexcept {
      return between(d, [&](std::size_t k) noexcept { return at(i, j, k); });
    });
  });
}

}  // namespace tcert
