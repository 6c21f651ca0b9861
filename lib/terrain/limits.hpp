#pragma once
/// \file
/// Bounds of every parameter of the exploration: within them no step overflows, and memory and work
/// are bounded.

#include <array>
#include <string_view>

namespace tcert::terrain {

/// Name, unit-free, as the tool's options have it, and what is allowed: low <= value <= high.
struct Limit {
  std::string_view name;
  double low = 0.0;
  double high = 0.0;
};

/// Cells a side. A side's covariance is a matrix of so many squared.
inline constexpr int kMostSide = 8192;
/// Cells of a terrain.
inline constexpr double kMostCells = 67108864.0;
/// Largest value of a cell or measurement, either way.
inline constexpr double kLargestValue = 1e30;

inline constexpr std::array kLimits{
    Limit{"threshold", -kLargestValue, kLargestValue},
    Limit{"lipschitz", 1e-30, 1e30},
    Limit{"beta", 0.0, 1e6},
    Limit{"expanders", 1.0, 1e9},
    Limit{"noise-bound", 0.0, kLargestValue},
    Limit{"travel-weight", 0.0, 1e6},
    Limit{"horizon", 1.0, 12.0},
    Limit{"growth-weight", 0.0, 1.0},
    Limit{"noise-sd", 0.0, kLargestValue},
    Limit{"gradient-prior", 0.0, 1e12},
    Limit{"confidence", 0.5, 0.999999},
    Limit{"kernel-mean", -kLargestValue, kLargestValue},
    // The certified rules derive it from the Lipschitz constant and the length scale, squared.
    Limit{"kernel-variance", 1e-70, 1e75},
    Limit{"kernel-length-scale", 1e-3, 1e6},
    Limit{"noise-variance", 0.0, 1e60},
    Limit{"simplification", 0.0, 1e4},
    Limit{"robot-radius", 0.0, 1e4},
    // Radius, length and width: the footprint is looked at row by row.
    Limit{"body", 0.0, 1000.0},
    Limit{"sub-goal-depth", 0.0, 1e4},
    Limit{"start-radius", 0.0, 100.0},
    Limit{"max-steps", 0.0, 1e5},
    Limit{"frames", 0.0, 64.0}};

/// \pre `name` is one of kLimits.
[[nodiscard]] constexpr Limit limit_of(std::string_view name) {
  for (const Limit& limit : kLimits) {
    if (limit.name == name) {
      return limit;
    }
  }
  return {};
}

/// NaN is not within any.
[[nodiscard]] constexpr bool is_within(const Limit& limit, double value) noexcept {
  return value >= limit.low && value <= limit.high;
}

/// \throws std::invalid_argument naming the parameter, its value and what is allowed.
void require_within(std::string_view name, double value);

}  // namespace tcert::terrain
