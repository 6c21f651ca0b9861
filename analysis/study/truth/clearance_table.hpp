#pragma once
/// \file
/// Clearances of a world at the points of a grid, to look up quickly.

#include <cstddef>
#include <vector>

#include "analysis/study/truth/obstacle_distance.hpp"
#include "datasets/world.hpp"

namespace tcert::study {

class ClearanceTable {
 public:
  /// Exact at the points; 0 inside obstacles. \throws std::invalid_argument as cell_grid.
  ClearanceTable(const World& world, const ObstacleDistance& obstacles, double step_m);

  /// Bilinear between the points; 0 outside of them. An estimate.
  [[nodiscard]] double at(Point p) const noexcept;

  /// From each point, the number of steps to `goal` over points of at least `clearance_m`;
  /// kUnreached where there is no way.
  static constexpr std::uint32_t kUnreached = 0xffff'ffffU;
  [[nodiscard]] std::vector<std::uint32_t> steps_to(const Region& goal, double clearance_m) const;

  /// Index of the point nearest to `p`.
  [[nodiscard]] std::size_t nearest(Point p) const noexcept;

 private:
  [[nodiscard]] Point point(std::size_t column, std::size_t row) const noexcept;

  Point origin_;
  double step_m_ = 0.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<float> clearance_;
};

}  // namespace tcert::study
