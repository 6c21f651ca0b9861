#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tcert/ray_lines.hpp>
#include <tcert/ray_sweep.hpp>
#include <tcert/strip_edge.hpp>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A cell that a border only touches is a candidate whatever the last bit says.
constexpr double kRounding = 1e-6;

std::int32_t cell_index(double at_m, double cell_m) noexcept {
  constexpr double kFar = 2.0e9;
  return static_cast<std::int32_t>(std::clamp(std::floor(at_m / cell_m), -kFar, kFar));
}

// Where the ray of a turning body pivots it stands still, and beyond it goes the other way.
constexpr double kShortOfPivot = 0.95;

}  // namespace

void RaySweep::anchor(Point mount, Point u, double clearance_m, double cell_m) noexcept {
  newest_ = 0;
  strips_[0] = {mount, u, {}, {}, {}, {}, 0.5 * cell_m * half_extent(u), 0.0, 0.0};
  count_ = 1;
  least_m_ = clearance_m;
}

void RaySweep::advance(Point mount,
                       Point u,
                       double clearance_m,
                       bool begin_in_body,
                       const SweepRule& rule,
                       SweptCells& cells) noexcept {
  if (std::isnan(clearance_m)) {
    restart();
    return;
  }
  if (count_ == 0) {
    anchor(mount, u, clearance_m, rule.cell_m);
    return;
  }
  const Strip& last = strip(0);
  least_m_ = std::min(least_m_, clearance_m);
  const Point step = mount - last.mount;
  const double tip_step_m = norm(step + least_m_ * (u - last.u));
  const double step_m = std::max(norm(step), tip_step_m);
  if (step_m < rule.least_step_m) {
    return;
  }
  // Both borders are square to the rays' middle direction, so that rays that slide along themselves
  // make no slanted strip; depths are along it, from the last mount.
  const Point middle = (1.0 / norm(last.u + u)) * (last.u + u);
  const double cosine = dot(u, middle);
  const double offset_m = dot(step, middle);
  const double lost_m = rule.lost_share * step_m;
  const double begin_m = std::max(0.0, offset_m) + (begin_in_body ? 0.0 : lost_m);
  const double pivot_m = crossing_m(last.mount, last.u, mount, u);
  const double end_m = std::min(least_m_ * cosine + std::min(0.0, offset_m) - lost_m,
                                kShortOfPivot * pivot_m * cosine);
  if (step_m > rule.least_obstacle_m || !(end_m > begin_m)) {
    anchor(mount, u, clearance_m, rule.cell_m);
    return;
  }
  const Point near_last = last.mount + (begin_m / cosine) * last.u;
  const Point far_last = last.mount + (end_m / cosine) * last.u;
  const Point near_now = mount + ((begin_m - offset_m) / cosine) * u;
  const Point far_now = mount + ((end_m - offset_m) / cosine) * u;
  const double ahead_near = cross(last.u, near_now - last.mount);
  const double ahead_far = cross(last.u, far_now - last.mount);
  const double behind_near = -cross(u, near_last - mount);
  const double behind_far = -cross(u, far_last - mount);
  const double side = ahead_near + behind_near < 0.0 ? -1.0 : 1.0;
  const bool crosses = side * ahead_near < 0.0 || side * ahead_far < 0.0 ||
                       side * behind_near < 0.0 || side * behind_far < 0.0;
  if (crosses || ahead_near + ahead_far == 0.0) {
    anchor(mount, u, clearance_m, rule.cell_m);
    return;
  }
  if (side != side_) {
    count_ = 1;  // it turned back: what it comes upon is what it has just left
    side_ = side;
  }
  newest_ = (newest_ + 1) % kKept;
  const double half_m = 0.5 * rule.cell_m;
  strips_[newest_] = {mount,
                      u,
                      near_last,
                      near_now - near_last,
                      far_last,
                      far_now - far_last,
                      half_m * half_extent(u),
                      half_m * half_extent(near_now - near_last),
                      half_m * half_extent(far_now - far_last)};
  count_ = std::min(count_ + 1, kKept);
  least_m_ = clearance_m;
  mark_passed(rule, cells);
}

// Whether the ray has gone from before the square to behind it, within the strips all the way.
// A point of the square then lies, in one of the strips, to the inside of all four borders, so the
// strip's ruled surface covers it.
bool RaySweep::passed(Point middle) const noexcept {
  const Strip& now = strip(0);
  if (side_ * cross(now.u, middle - now.mount) + now.cell_u > 0.0) {
    return false;
  }
  const Strip& last = strip(1);
  if (side_ * cross(last.u, middle - last.mount) + last.cell_u <= 0.0) {
    return false;  // it was passed, or lost, before
  }
  for (std::size_t back = 0; back + 1 < count_; ++back) {
    const Strip& s = strip(back);
    const Strip& before = strip(back + 1);
    const double inside_far = side_ * cross(s.far_along, middle - s.far_from);
    const double inside_near = -side_ * cross(s.near_along, middle - s.near_from);
    if (inside_far < s.cell_far || inside_near < s.cell_near) {
      return false;
    }
    if (side_ * cross(before.u, middle - before.mount) >= before.cell_u) {
      return true;
    }
  }
  return false;
}

// What the ray passes with this strip is behind it now and was not, all of it, behind it before; so
// it meets the strip.
void RaySweep::mark_passed(const SweepRule& rule, SweptCells& cells) const noexcept {
  const Strip& s = strip(0);
  const Point far_to = s.far_from + s.far_along;
  const Point near_to = s.near_from + s.near_along;
  const std::array<StripEdge, 4> edges{StripEdge(s.near_from, s.far_from),
                                       StripEdge(s.far_from, far_to),
                                       StripEdge(far_to, near_to),
                                       StripEdge(near_to, s.near_from)};
  const auto [low, high] = std::minmax({s.near_from.y_m, s.far_from.y_m, far_to.y_m, near_to.y_m});
  const double rounding_m = kRounding * rule.cell_m;
  const std::int32_t last_row = cell_index(high + rounding_m, rule.cell_m);
  for (std::int32_t iy = cell_index(low - rounding_m, rule.cell_m); iy <= last_row; ++iy) {
    const double bottom = static_cast<double>(iy) * rule.cell_m;
    const double top = static_cast<double>(iy + 1) * rule.cell_m;
    double from = kInfinity;
    double to = -from;
    for (const StripEdge& edge : edges) {
      edge.add_range(bottom, top, from, to);
    }
    if (from > to) {
      continue;
    }
    const std::int32_t last = cell_index(to + rounding_m, rule.cell_m);
    std::int32_t run_first = 0;
    std::int32_t run_last = -1;  // below run_first: no cell
    for (std::int32_t ix = cell_index(from - rounding_m, rule.cell_m); ix <= last; ++ix) {
      const Point middle{(static_cast<double>(ix) + 0.5) * rule.cell_m, 0.5 * (bottom + top)};
      if (!passed(middle)) {
        continue;
      }
      if (run_last + 1 != ix) {
        cells.mark_run(iy, run_first, run_last);
        run_first = ix;
      }
      run_last = ix;
    }
    cells.mark_run(iy, run_first, run_last);
  }
}

}  // namespace tcert
