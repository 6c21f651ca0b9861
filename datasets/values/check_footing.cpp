#include "datasets/values/check_footing.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace tcert {
namespace {

struct Bound {
  double Footing::*member;
  const char* column;
  double most;
  const char* expectation;
};

constexpr double kRightAngle = 0.5 * std::numbers::pi;

constexpr std::array kBounds{
    Bound{&Footing::pitch_rad, "pitch_rad", kRightAngle, "radians below a right angle: degrees?"},
    Bound{&Footing::roll_rad, "roll_rad", kRightAngle, "radians below a right angle: degrees?"},
    Bound{&Footing::step_m, "step_m", 1.0, "metres: millimetres or centimetres?"},
    Bound{&Footing::slip, "slip", 1.5, "a share of the way, 1 is all of it: per cent?"}};

}  // namespace

std::optional<ValueFinding> check_footing(const TickTable& ticks) {
  for (const Bound& bound : kBounds) {
    double largest = 0.0;
    for (const Footing& footing : ticks.footing) {
      const double size = std::abs(footing.*bound.member);
      largest = size > largest ? size : largest;
    }
    if (largest > bound.most) {
      return value_finding(ValueKind::footing,
                           bound.column,
                           fmt::format("values up to {:.3g}", largest),
                           bound.expectation);
    }
  }
  return std::nullopt;
}

}  // namespace tcert
