#include "analysis/study/truth/clearance_table.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/study/truth/cell_grid.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert::study {

ClearanceTable::ClearanceTable(const World& world, const ObstacleDistance& obstacles, double step_m)
    : step_m_(step_m) {
  const CellGrid grid = cell_grid(world, step_m);
  origin_ = grid.centre(0, 0);
  columns_ = grid.columns;
  rows_ = grid.rows;
  std::vector<std::uint8_t> inside(grid.size(), 0);
  for (const Region& obstacle : world.obstacles) {
    mark_region(grid, obstacle, 0.0, inside);
  }
  clearance_.resize(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    clearance_[i] = inside[i] != 0 ? 0.0F : static_cast<float>(obstacles.at(grid.centre(i)));
  }
}

Point ClearanceTable::point(std::size_t column, std::size_t row) const noexcept {
  return {origin_.x_m + static_cast<double>(column) * step_m_,
          origin_.y_m + static_cast<double>(row) * step_m_};
}

double ClearanceTable::at(Point p) const noexcept {
  const double u = (p.x_m - origin_.x_m) / step_m_;
  const double v = (p.y_m - origin_.y_m) / step_m_;
  if (!(u >= 0.0 && v >= 0.0)) {
    return 0.0;
  }
  const auto column = static_cast<std::size_t>(u);
  const auto row = static_cast<std::size_t>(v);
  if (column + 1 >= columns_ || row + 1 >= rows_) {
    return 0.0;
  }
  const double s = u - static_cast<double>(column);
  const double t = v - static_cast<double>(row);
  const float* const low = clearance_.data() + row * columns_ + column;
  const float* const high = low + columns_;
  return (1.0 - t) * ((1.0 - s) * static_cast<double>(low[0]) + s * static_cast<double>(low[1])) +
         t * ((1.0 - s) * static_cast<double>(high[0]) + s * static_cast<double>(high[1]));
}

std::size_t ClearanceTable::nearest(Point p) const noexcept {
  const auto place = [this](double from, double value, std::size_t count) {
    return static_cast<std::size_t>(
        std::clamp(std::round((value - from) / step_m_), 0.0, static_cast<double>(count - 1)));
  };
  return place(origin_.y_m, p.y_m, rows_) * columns_ + place(origin_.x_m, p.x_m, columns_);
}

std::vector<std::uint32_t> ClearanceTable::steps_to(const Region& goal, double clearance_m) const {
  std::vector<std::uint32_t> steps(clearance_.size(), kUnreached);
  std::vector<std::size_t> queue;
  for (std::size_t i = 0; i < clearance_.size(); ++i) {
    if (region_distance(goal, point(i % columns_, i / columns_)) <= step_m_) {
      steps[i] = 0;
      queue.push_back(i);
    }
  }
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::size_t i = queue[next];
    const std::size_t column = i % columns_;
    const auto visit = [&](bool there, std::size_t j) {
      if (there && steps[j] == kUnreached && static_cast<double>(clearance_[j]) >= clearance_m) {
        steps[j] = steps[i] + 1;
        queue.push_back(j);
      }
    };
    visit(column > 0, i - 1);
    visit(column + 1 < columns_, i + 1);
    visit(i >= columns_, i - columns_);
    visit(i + columns_ < clearance_.size(), i + columns_);
  }
  return steps;
}

}  // namespace tcert::study
