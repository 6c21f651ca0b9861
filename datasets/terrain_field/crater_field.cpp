#include "datasets/terrain_field/crater_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <table/random.hpp>
#include <tcert/elementary.hpp>

namespace tcert {
namespace {

constexpr std::uint32_t kCraterPurpose = 0x7e44a2;  // of the random stream

struct Crater {
  double x = 0.0;
  double y = 0.0;
  double radius = 0.0;
  double depth = 0.0;
  double rim = 0.0;

  [[nodiscard]] double height(double px, double py) const {
    const double dx = px - x;
    const double dy = py - y;
    const double share2 = (dx * dx + dy * dy) / (radius * radius);
    return share2 < 1.0 ? -depth + (depth + rim) * share2 : rim / (share2 * std::sqrt(share2));
  }
};

[[nodiscard]] std::vector<Crater> craters_of(const CraterFieldOptions& o) {
  table::RandomStream random(o.seed, kCraterPurpose, o.number);
  const double small = 1.0 / (o.least_diameter * o.least_diameter);
  const double large = 1.0 / (o.most_diameter * o.most_diameter);
  const double area = static_cast<double>(o.rows) * o.columns;
  const auto count = static_cast<std::size_t>(std::lround(o.density * area * (small - large)));
  std::vector<Crater> craters;
  for (std::size_t k = 0; k < count; ++k) {
    const double diameter = 1.0 / std::sqrt(random.uniform(large, small));
    const double fresh = random.uniform(0.1, 1.0);
    craters.push_back({random.uniform(0.0, o.rows),
                       random.uniform(0.0, o.columns),
                       0.5 * diameter,
                       fresh * diameter / 5.0,
                       fresh * diameter / 25.0});
  }
  return craters;
}

}  // namespace

TerrainGrid crater_slopes(const CraterFieldOptions& o) {
  if (o.rows < 3 || o.columns < 3) {
    throw std::invalid_argument("a field of craters needs at least 3 x 3 cells");
  }
  if (!(o.least_diameter > 0.0) || !(o.most_diameter > o.least_diameter) || !(o.density >= 0.0) ||
      o.reach < 1 || o.reach > 100) {
    throw std::invalid_argument(
        "craters need diameters above 0, a density of at least 0 and a reach of 1 to 100");
  }
  const std::vector<Crater> craters = craters_of(o);
  const int rim = o.reach;
  const int width = o.columns + 2 * rim;
  std::vector<double> height;
  for (int x = -rim; x < o.rows + rim; ++x) {
    for (int y = -rim; y < o.columns + rim; ++y) {
      double z = 0.0;
      for (const Crater& crater : craters) {
        z += crater.height(x, y);
      }
      height.push_back(z);
    }
  }
  const auto at = [&](int x, int y) {
    return height[static_cast<std::size_t>(x + rim) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(y + rim)];
  };
  // Of the plane: products of heights and offsets over the sum of squared offsets.
  double squares = 0.0;
  for (int d = -rim; d <= rim; ++d) {
    squares += static_cast<double>(d) * d * (2 * rim + 1);
  }
  TerrainGrid terrain{o.rows, o.columns, {}, {}};
  for (int x = 0; x < o.rows; ++x) {
    for (int y = 0; y < o.columns; ++y) {
      double down = 0.0;
      double across = 0.0;
      for (int dx = -rim; dx <= rim; ++dx) {
        for (int dy = -rim; dy <= rim; ++dy) {
          down += dx * at(x + dx, y + dy);
          across += dy * at(x + dx, y + dy);
        }
      }
      down /= squares;
      across /= squares;
      const double slope = elementary::atan2(std::sqrt(down * down + across * across), 1.0) *
                           180.0 / std::numbers::pi;
      terrain.values.push_back(o.slope_limit - slope);
    }
  }
  return terrain;
}

}  // namespace tcert
