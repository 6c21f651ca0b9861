#include <algorithm>
#include <cmath>
#include <limits>
#include <tcert/ray_lines.hpp>
#include <tcert/strip_edge.hpp>
#include <witness/ray_strips.hpp>

namespace tcert::witness {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLeastStep = 0.001;  // m
constexpr double kJitter = 0.012;     // m
constexpr double kCrossing = 0.03;    // m, within which a crossing is dropped
// Depths this near to where two rays cross are left out.
constexpr double kShortOfPivot = 0.95;
constexpr double kBeyondPivot = 1.05;
// A cell that a border only touches is a candidate whatever the last bit says.
constexpr double kRounding = 1e-6;

}  // namespace

void RayStrips::anchor(Point mount, Point u, double clearance_m) noexcept {
  newest_ = 0;
  strips_[0] = {mount, u, u, 0.0, 0.0};
  count_ = 1;
  side_ = 0.0;
  clearance_m_ = clearance_m;
}

void RayStrips::advance(Point mount,
                        Point u,
                        double clearance_m,
                        double body_gap_m,
                        const StripRule& rule,
                        FreeCells& cells) noexcept {
  if (std::isnan(clearance_m)) {
    return;
  }
  clearance_m = std::max(0.0, clearance_m - rule.reading_bound_m);
  if (count_ == 0) {
    anchor(mount, u, clearance_m);
    return;
  }
  const Strip& last = strip(0);
  const double least_m = std::min(clearance_m_, clearance_m);
  const Point step = mount - last.mount;
  const double step_m = std::max(norm(step), norm(step + least_m * (u - last.u)));
  if (step_m < kLeastStep) {
    return;
  }
  if (step_m > rule.least_obstacle_m || dot(u, last.u) < 0.5) {
    anchor(mount, u, clearance_m);
    return;
  }
  // Both borders are square to the middle direction; depths are along it, from the last mount.
  const Point middle = (1.0 / norm(last.u + u)) * (last.u + u);
  const double cosine = dot(u, middle);
  const double offset_m = dot(step, middle);
  const double lost_m = rule.lost_share * step_m;
  Span span{std::max(0.0, offset_m) + (body_gap_m >= lost_m ? 0.0 : lost_m),
            least_m * cosine + std::min(0.0, offset_m) - lost_m};
  const double pivot_m = cosine * crossing_m(last.mount, last.u, mount, u);
  const Span before{span.begin_m, std::min(span.end_m, kShortOfPivot * pivot_m)};
  const Span beyond{std::max(span.begin_m, kBeyondPivot * pivot_m), span.end_m};
  span = before.end_m - before.begin_m >= beyond.end_m - beyond.begin_m ? before : beyond;
  if (span.empty()) {
    if (step_m >= kCrossing) {
      anchor(mount, u, clearance_m);
    }
    return;
  }
  const std::array<Point, 4> corners{last.mount + (span.begin_m / cosine) * last.u,
                                     last.mount + (span.end_m / cosine) * last.u,
                                     mount + ((span.end_m - offset_m) / cosine) * u,
                                     mount + ((span.begin_m - offset_m) / cosine) * u};
  const double side =
      cross(last.u, corners[2] + corners[3] - corners[1] - corners[0]) < 0.0 ? -1.0 : 1.0;
  if (side != side_) {
    if (side_ != 0.0 && step_m < kJitter) {
      return;  // not yet turned back
    }
    count_ = 1;  // what it comes upon is what it has just left
    side_ = side;
  }
  const double depth_m = dot(middle, last.mount);
  newest_ = (newest_ + 1) % kKept;
  strips_[newest_] = {mount, u, middle, depth_m + span.begin_m, depth_m + span.end_m};
  count_ = std::min(count_ + 1, kKept);
  clearance_m_ = clearance_m;
  mark_passed(corners, cells);
}

// Whether the ray has gone from before the square to behind it, within the strips' depths all the
// way. Each point of the square then lies between two neighbouring positions of the ray, and within
// the depths of their strip.
bool RayStrips::passed(Point middle, double half_m) const noexcept {
  const Strip& now = strip(0);
  if (side_ * cross(now.u, middle - now.mount) + half_m * half_extent(now.u) > 0.0) {
    return false;
  }
  const Strip& last = strip(1);
  if (side_ * cross(last.u, middle - last.mount) + half_m * half_extent(last.u) <= 0.0) {
    return false;  // it was passed, or lost, before
  }
  for (std::size_t back = 0; back + 1 < count_; ++back) {
    const Strip& s = strip(back);
    const double depth_m = dot(s.middle, middle);
    const double half_depth_m = half_m * half_extent(s.middle);
    if (depth_m - half_depth_m < s.near_m || depth_m + half_depth_m > s.far_m) {
      return false;
    }
    const Strip& before = strip(back + 1);
    if (side_ * cross(before.u, middle - before.mount) >= half_m * half_extent(before.u)) {
      return true;
    }
  }
  return false;
}

// What the ray passes with this strip is behind it now and was not, all of it, behind it before; so
// it meets the strip, and in each row lies between the ends of what the strip's edges take of it.
void RayStrips::mark_passed(const std::array<Point, 4>& corners, FreeCells& cells) const noexcept {
  const Lattice& lattice = cells.lattice();
  const double cell_m = lattice.cell_m;
  const double rounding_m = kRounding * cell_m;
  const auto [low, high] =
      std::minmax({corners[0].y_m, corners[1].y_m, corners[2].y_m, corners[3].y_m});
  const std::array<StripEdge, 4> edges{StripEdge(corners[0], corners[1]),
                                       StripEdge(corners[1], corners[2]),
                                       StripEdge(corners[2], corners[3]),
                                       StripEdge(corners[3], corners[0])};
  const int first_row = std::max(0, lattice.row_of(low - rounding_m));
  const int last_row = std::min(lattice.rows - 1, lattice.row_of(high + rounding_m));
  for (int iy = first_row; iy <= last_row; ++iy) {
    const double bottom = lattice.corner(0, iy).y_m;
    const double top = lattice.corner(0, iy + 1).y_m;
    double from = kInfinity;
    double to = -kInfinity;
    for (const StripEdge& edge : edges) {
      edge.add_range(bottom - rounding_m, top + rounding_m, from, to);
    }
    if (from > to) {
      continue;
    }
    const int first = std::max(0, lattice.column_of(from - rounding_m));
    const int last = std::min(lattice.columns - 1, lattice.column_of(to + rounding_m));
    for (int ix = first; ix <= last; ++ix) {
      const Point corner = lattice.corner(ix, iy);
      const Point middle{corner.x_m + 0.5 * cell_m, corner.y_m + 0.5 * cell_m};
      if (!cells.is_free(ix, iy) && passed(middle, 0.5 * cell_m)) {
        cells.mark(ix, iy);
      }
    }
  }
}

}  // namespace tcert::witness
