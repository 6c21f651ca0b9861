#include <algorithm>
#include <cmath>
#include <tcert/bend_variance.hpp>

namespace tcert::policies {
namespace {

constexpr double kUnit = 0x1p18;
constexpr double kMostBend = 8.0;

}  // namespace

BendVariance::BendVariance(const Robot& robot, double window_m, double step_m)
    : window_m_(window_m),
      step_m_(step_m),
      windows_(robot.rays.size(), Window(window_m, step_m)),
      rad2_(robot.rays.size(), kMissing) {
  for (const Ray& ray : robot.rays) {
    bends_.push_back(ray.kind == RayKind::bend);
  }
}

void BendVariance::reset() noexcept {
  for (Window& window : windows_) {
    window.samples.clear();
    window.count = window.sum = window.square_sum = 0;
  }
  std::fill(rad2_.begin(), rad2_.end(), kMissing);
}

void BendVariance::count(Window& window, std::int64_t bend, std::int64_t sign) noexcept {
  window.count += sign;
  window.sum += sign * bend;
  window.square_sum += sign * bend * bend;
}

void BendVariance::drop_old(Window& window, double travel_m) const noexcept {
  while (!window.samples.empty() &&
         exceeds(travel_m - window.samples.front().travel_m, window_m_)) {
    count(window, window.samples.front().bend, -1);
    window.samples.pop_front();
  }
}

void BendVariance::add(double travel_m, std::span<const RayReading> readings) noexcept {
  for (std::size_t i = 0; i < std::min(readings.size(), windows_.size()); ++i) {
    Window& window = windows_[i];
    const double bend_rad = readings[i].value;
    const bool due =
        window.samples.empty() || reaches(travel_m - window.samples.back().travel_m, step_m_);
    if (!bends_[i] || !std::isfinite(bend_rad) || !due) {
      continue;
    }
    drop_old(window, travel_m);
    const auto bend =
        static_cast<std::int64_t>(std::round(std::clamp(bend_rad, -kMostBend, kMostBend) * kUnit));
    window.samples.push_back({travel_m, bend});
    count(window, bend, 1);
    // n sum b^2 - (sum b)^2, of at most 1003 samples below 2^22, stays below 2^63.
    const std::int64_t spread = window.count * window.square_sum - window.sum * window.sum;
    const auto n = static_cast<double>(window.count);
    rad2_[i] = window.count < 2 ? kMissing : static_cast<double>(spread) / (n * n * kUnit * kUnit);
  }
}

}  // namespace tcert::policies
