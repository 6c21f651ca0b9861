#pragma once
/// \file
/// What one ray proves free as it is carried from tick to tick.

#include <array>
#include <cstddef>
#include <tcert/geometry.hpp>
#include <tcert/swept_cells.hpp>

namespace tcert {

/// How a ray's sweep is credited. Lengths in metres.
struct SweepRule {
  double cell_m = 0.02;
  double least_step_m = 0.01;      ///< A ray that moved less is not yet a new one.
  double least_obstacle_m = 0.08;  ///< No obstacle is narrower than this.
  double lost_share = 0.5;         ///< 1 / (2 tan(a / 2)) of the rule below; at least 0.5.
};

/// The last positions of one ray. Two neighbours span a strip, as long as the smallest clearance
/// read at them or between, less what an obstacle that neither of the two met can reach in between.
/// The rule for obstacles: at depth h behind its tip each is at least 2 h tan(a / 2) wide, up to
/// least_obstacle_m. So one that fits between rays whose tips are d <= least_obstacle_m apart
/// reaches no further than d / (2 tan(a / 2)) past them. Corners of at least a keep the rule, and
/// for a = pi/2 discs of that diameter do; for a larger a they do not. A cell is free if, while the
/// ray went from before it to behind it, the cell lay within every strip on the way.
class RaySweep {
 public:
  void restart() noexcept { count_ = 0; }

  /// The ray's next position: from `mount` along the unit vector `u`, free for `clearance_m` (NaN:
  /// not known). Marks the cells that it has passed. `begin_in_body` if the mount lies deep in the
  /// body, which nothing can reach through.
  void advance(Point mount,
               Point u,
               double clearance_m,
               bool begin_in_body,
               const SweepRule& rule,
               SweptCells& cells) noexcept;

 private:
  static constexpr std::size_t kKept = 16;
  struct Strip {
    Point mount;  // of the ray at the strip's end, and its direction
    Point u;
    Point near_from, near_along;  // the strip's inner border: a point and the way to the next one
    Point far_from, far_along;    // its outer border
    // Half the extents of a cell across the ray and across both borders.
    double cell_u = 0.0, cell_near = 0.0, cell_far = 0.0;
  };
  [[nodiscard]] const Strip& strip(std::size_t back) const noexcept {
    return strips_[(newest_ + kKept - back) % kKept];
  }
  void anchor(Point mount, Point u, double clearance_m, double cell_m) noexcept;
  void mark_passed(const SweepRule& rule, SweptCells& cells) const noexcept;
  [[nodiscard]] bool passed(Point middle) const noexcept;

  std::array<Strip, kKept> strips_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 0;  // of positions kept; the oldest one ends no strip
  double side_ = 1.0;      // +1: the ray moves to its left
  double least_m_ = 0.0;   // clearance since the newest position
};

}  // namespace tcert
