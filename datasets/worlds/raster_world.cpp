#include "datasets/worlds/raster_world.hpp"

#include <map>
#include <utility>

namespace tcert {

World raster_world(const Raster& raster, Point low_corner, double cell_m) {
  World world;
  const auto at = [&](std::size_t column, std::size_t rows_from_top) {
    return low_corner + cell_m * Point{static_cast<double>(column),
                                       static_cast<double>(raster.rows - rows_from_top)};
  };
  world.bounds = {low_corner, at(raster.columns, 0)};
  using Run = std::pair<std::size_t, std::size_t>;  // columns [first, last)
  std::map<Run, std::size_t> open;                  // run -> the row that it began in
  const auto close = [&](const Run& run, std::size_t from, std::size_t to) {
    world.obstacles.emplace_back(Polygon{
        {at(run.first, to), at(run.second, to), at(run.second, from), at(run.first, from)}});
  };
  for (std::size_t row = 0; row <= raster.rows; ++row) {
    std::map<Run, std::size_t> next;
    for (std::size_t column = 0; row < raster.rows && column < raster.columns;) {
      const std::size_t first = column;
      while (column < raster.columns && raster.occupied[row * raster.columns + column] != 0) {
        ++column;
      }
      if (column == first) {
        ++column;
        continue;
      }
      const Run run{first, column};
      const auto before = open.find(run);
      next.emplace(run, before != open.end() ? before->second : row);
    }
    for (const auto& [run, from] : open) {
      if (!next.contains(run)) {
        close(run, from, row);
      }
    }
    open = std::move(next);
  }
  return world;
}

}  // namespace tcert
