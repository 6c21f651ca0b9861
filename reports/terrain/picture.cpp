#include "reports/terrain/picture.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tcert {
namespace {

using terrain::Cell;
using terrain::CellSet;
using terrain::Grid;
using terrain::Position;

constexpr std::size_t kMostFrames = 64;

/// Runs of members along y, as one path of rectangles of a cell's width.
[[nodiscard]] std::string runs(const Grid& grid, const CellSet& set) {
  std::string path;
  for (int x = 0; x < grid.rows; ++x) {
    int y = 0;
    while (y < grid.columns) {
      const int from = y;
      while (y < grid.columns && set[grid.index({x, y})] != 0) {
        ++y;
      }
      if (y > from) {
        path += fmt::format("M{} {}h1v{}h-1z", x, from, y - from);
      } else {
        ++y;
      }
    }
  }
  return path;
}

void layer(std::string& svg, const Grid& grid, const CellSet& set, std::string_view colour) {
  const std::string path = runs(grid, set);
  if (!path.empty()) {
    svg += fmt::format("<path fill=\"{}\" d=\"{}\"/>\n", colour, path);
  }
}

/// The box round a set, without the set.
[[nodiscard]] CellSet obstacles_of(const Grid& grid, const CellSet& safe) {
  Cell low{grid.rows, grid.columns};
  Cell high{-1, -1};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (safe[i] != 0) {
      const Cell c = grid.cell(i);
      low = {std::min(low.x, c.x), std::min(low.y, c.y)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
  }
  CellSet black(grid.size(), 0);
  for (int x = low.x; x <= high.x; ++x) {
    for (int y = low.y; y <= high.y; ++y) {
      black[grid.index({x, y})] = safe[grid.index({x, y})] == 0 ? 1 : 0;
    }
  }
  return black;
}

[[nodiscard]] std::string polyline(const std::vector<Position>& points, std::size_t count) {
  std::string text;
  for (std::size_t k = 0; k < std::min(count, points.size()); ++k) {
    text += fmt::format("{:.2f},{:.2f} ", points[k].x() + 0.5, points[k].y() + 0.5);
  }
  return text;
}

void disc(std::string& svg, const Position& p, double radius, std::string_view colour) {
  svg += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{}\" fill=\"{}\"/>\n",
                     p.x() + 0.5,
                     p.y() + 0.5,
                     radius,
                     colour);
}

}  // namespace

void FrameKeeper::add(ExploreFrame frame) {
  if (frame.step % stride_ == 0) {
    kept_.push_back(frame);
  }
  last_ = std::move(frame);
  if (kept_.size() > kMostFrames) {
    stride_ *= 2;
    std::erase_if(kept_, [&](const ExploreFrame& one) { return one.step % stride_ != 0; });
  }
}

std::vector<ExploreFrame> FrameKeeper::evenly(std::size_t wanted) const {
  std::vector<ExploreFrame> all = kept_;
  if (last_ && (all.empty() || all.back().step != last_->step)) {
    all.push_back(*last_);
  }
  if (all.size() <= wanted) {
    return all;
  }
  if (wanted < 2) {
    return wanted == 0 ? std::vector<ExploreFrame>{} : std::vector<ExploreFrame>{all.back()};
  }
  std::vector<ExploreFrame> chosen;
  const int first = all.front().step;
  const int span = all.back().step - first;
  std::size_t from = 0;
  for (std::size_t k = 0; k < wanted; ++k) {
    const double at = first + static_cast<double>(span) * static_cast<double>(k) /
                                  static_cast<double>(wanted - 1);
    std::size_t best = from;
    for (std::size_t i = from; i < all.size() - (wanted - 1 - k); ++i) {
      if (std::abs(all[i].step - at) < std::abs(all[best].step - at)) {
        best = i;
      }
    }
    chosen.push_back(all[best]);
    from = best + 1;
  }
  return chosen;
}

std::string explore_picture(const terrain::Terrain& terrain,
                            double threshold,
                            const ExploreFrame& frame,
                            const std::vector<Position>& path,
                            std::optional<Cell> goal,
                            const std::optional<SyntheticLabel>& synthetic) {
  const Grid& grid = terrain.grid;
  CellSet unsafe(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    unsafe[i] = terrain.values[i] >= threshold ? 0 : 1;
  }
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\" "
      "height=\"{}\" shape-rendering=\"crispEdges\">\n<title>{}step {}</title>\n"
      "<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n",
      grid.rows,
      grid.columns,
      grid.rows,
      grid.columns,
      synthetic ? to_string(*synthetic) + " " : "",
      frame.step,
      grid.rows,
      grid.columns);
  layer(svg, grid, unsafe, "#b0b0b0");
  layer(svg, grid, frame.safe, "#a6d8f5");
  layer(svg, grid, frame.expanders, "#e02020");
  if (!frame.free_space.empty()) {
    svg += fmt::format("<polygon fill=\"#30b050\" fill-opacity=\"0.7\" points=\"{}\"/>\n",
                       polyline(frame.free_space, frame.free_space.size()));
  }
  // Over the free space, which lies in the mapped plane: green shows on safe ground alone.
  layer(svg, grid, obstacles_of(grid, frame.safe), "#000000");
  svg += fmt::format(
      "<polyline fill=\"none\" stroke=\"#404040\" stroke-width=\"0.8\" points=\"{}\"/>\n",
      polyline(path, frame.path_points));
  if (frame.next) {
    disc(svg, terrain::position(*frame.next), 3.0, "#ff69b4");
  }
  if (goal) {
    disc(svg, terrain::position(*goal), 4.0, "#00007f");
  }
  disc(svg, frame.robot, 2.0, "#ff8c00");
  return svg + "</svg>\n";
}

}  // namespace tcert
