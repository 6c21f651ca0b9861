#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#include <witness/free_space.hpp>
#include <witness/region_shape.hpp>

namespace tcert::witness {
namespace {

// The body's disc is marked anew after this much of the way.
constexpr double kBodyStep = 0.004;

void widen(Box& box, Point p, double by_m) noexcept {
  box.low = {std::min(box.low.x_m, p.x_m - by_m), std::min(box.low.y_m, p.y_m - by_m)};
  box.high = {std::max(box.high.x_m, p.x_m + by_m), std::max(box.high.y_m, p.y_m + by_m)};
}

Box box_of_run(const Robot& robot, const Samples& samples) noexcept {
  double reach_m = 0.5 * robot.body_width_m;
  for (const Ray& ray : robot.rays) {
    reach_m = std::max(reach_m, norm(ray.mount) + ray.reach_m);
  }
  Box box{samples.poses.front().position, samples.poses.front().position};
  for (const Pose& pose : samples.poses) {
    widen(box, pose.position, reach_m);
  }
  return box;
}

void mark_disc(Point centre, double radius_m, FreeCells& cells) noexcept {
  const Lattice& lattice = cells.lattice();
  const int last = std::min(lattice.rows - 1, lattice.row_of(centre.y_m + radius_m));
  for (int iy = std::max(0, lattice.row_of(centre.y_m - radius_m)); iy <= last; ++iy) {
    const double off_m = std::max(centre.y_m - lattice.corner(0, iy).y_m,
                                  lattice.corner(0, iy + 1).y_m - centre.y_m);
    if (off_m >= radius_m) {
      continue;
    }
    const double half_m = std::sqrt(radius_m * radius_m - off_m * off_m);
    // The first and the last column that the row of the disc covers as a whole.
    const int left = lattice.column_of(centre.x_m - half_m) + 1;
    const int right = lattice.column_of(centre.x_m + half_m) - 1;
    cells.mark_run(iy, left, right);
  }
}

/// O(rows x vertices + cells x edges near a row).
void mark_region(const Region& region, FreeCells& cells) {
  const Lattice& lattice = cells.lattice();
  const Box box = bounding_box(region);
  for (int iy = lattice.row_of(box.low.y_m); iy <= lattice.row_of(box.high.y_m); ++iy) {
    const Point low = lattice.corner(0, iy);
    const Point middle = 0.5 * (low + lattice.corner(1, iy + 1));
    const RowOfRegion row(region, middle.y_m, distance(low, middle));
    for (int ix = lattice.column_of(box.low.x_m); ix <= lattice.column_of(box.high.x_m); ++ix) {
      if (row.covers({lattice.corner(ix, iy), lattice.corner(ix + 1, iy + 1)})) {
        cells.mark_run(iy, ix, ix);
      }
    }
  }
}

}  // namespace

Region start_of(const Robot& robot, const Course& course, const Samples& samples) {
  return course.start.value_or(
      Region(Disc{samples.poses.front().position, 0.5 * robot.body_width_m}));
}

FreeCells free_space(const Robot& robot,
                     const Course& course,
                     const Samples& samples,
                     const FreeSpaceOptions& options) {
  if (samples.size() == 0) {
    return {};
  }
  std::vector<Region> regions{start_of(robot, course, samples)};
  if (course.goal) {
    regions.push_back(*course.goal);
  }
  Box box = box_of_run(robot, samples);
  for (const Region& region : regions) {
    const Box around = bounding_box(region);
    widen(box, around.low, 0.0);
    widen(box, around.high, 0.0);
  }
  FreeCells cells(box.low, box.high, options.cell_m, options.max_cells);
  for (const Region& region : regions) {
    mark_region(region, cells);
  }
  const double body_radius_m = 0.5 * robot.body_width_m;
  std::vector<RayStrips> strips(robot.rays.size());
  Point marked{std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Pose& pose = samples.poses[i];
    if (!(distance(marked, pose.position) <= kBodyStep)) {
      marked = pose.position;
      mark_disc(marked, body_radius_m, cells);
    }
    for (std::size_t k = 0; k < strips.size(); ++k) {
      const Ray& ray = robot.rays[k];
      if (samples.breaks[i] != 0) {
        strips[k].restart();
      }
      strips[k].advance(transform(pose, ray.mount),
                        samples.direction_of(robot, i, k),
                        samples.clearances_m[i * samples.rays + k],
                        body_radius_m - norm(ray.mount),
                        options.strips,
                        cells);
    }
  }
  return cells;
}

}  // namespace tcert::witness
