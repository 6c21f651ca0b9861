#include <algorithm>
#include <stdexcept>
#include <string>
#include <tcert/course_grid.hpp>

namespace tcert::policies {
namespace {

constexpr double kFar = 1e9;  // cells; no sum of two such numbers overflows

std::int32_t nearest_whole(double x) noexcept {
  return static_cast<std::int32_t>(std::round(std::clamp(x, -kFar, kFar)));
}

}  // namespace

CourseGrid::CourseGrid(const PolicySetup& setup) : cell_m_(setup.parameters.policy_cell_m) {
  const CourseLine& line = setup.line;
  const double columns = (line.high.x_m - line.low.x_m) / cell_m_ + 4.0;
  const double rows = (line.high.y_m - line.low.y_m) / cell_m_ + 4.0;
  if (!(columns * rows <= setup.parameters.max_policy_cells)) {
    throw std::invalid_argument(
        "the course has about " + to_text(std::ceil(columns * rows)) +
        " cells of policy_cell_m; raise it, or max_policy_cells, which is " +
        to_text(setup.parameters.max_policy_cells));
  }
  low_ = cell_at(line.low) + GridCell{-1, -1};
  const GridCell high = cell_at(line.high) + GridCell{1, 1};
  columns_ = static_cast<std::uint32_t>(high.x - low_.x + 1);
  rows_ = static_cast<std::uint32_t>(high.y - low_.y + 1);
}

GridCell CourseGrid::cell_at(Point p) const noexcept {
  return {nearest_whole(p.x_m / cell_m_), nearest_whole(p.y_m / cell_m_)};
}

std::uint32_t CourseGrid::index(GridCell cell) const noexcept {
  const auto column = static_cast<std::uint32_t>(cell.x - low_.x);
  const auto row = static_cast<std::uint32_t>(cell.y - low_.y);
  return column < columns_ && row < rows_ ? row * columns_ + column : kOutside;
}

GridCell CourseGrid::cell(std::uint32_t index) const noexcept {
  return low_ + GridCell{static_cast<std::int32_t>(index % columns_),
                         static_cast<std::int32_t>(index / columns_)};
}

GridCell CourseGrid::clamped(GridCell cell) const noexcept {
  return {std::clamp(cell.x, low_.x, low_.x + static_cast<std::int32_t>(columns_) - 1),
          std::clamp(cell.y, low_.y, low_.y + static_cast<std::int32_t>(rows_) - 1)};
}

}  // namespace tcert::policies
