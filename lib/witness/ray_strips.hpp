#pragma once
/// \file
/// What one ray proves free as it is carried along: the strips between its positions.

#include <array>
#include <cstddef>
#include <tcert/geometry.hpp>
#include <witness/free_cells.hpp>

namespace tcert::witness {

/// How strips are credited. Lengths in metres.
struct StripRule {
  double least_obstacle_m = 0.08;  ///< No obstacle is narrower; a longer gap proves nothing.
  double lost_share = 0.5;         ///< 1 / (2 tan(a / 2)) of the rule below; at least 0.5.
  double reading_bound_m = 0.0;    ///< Taken off every reading.
};

/// The last positions of one ray. Two of them whose readings' tips, and mounts, are d <=
/// least_obstacle_m apart span a strip: as deep as the smaller reading, less lost_share * d. The
/// rule for obstacles is that of tcert::RaySweep: at depth h behind its tip each is at least
/// 2 h tan(a / 2) wide, up to least_obstacle_m, so that what lies between two free rays reaches no
/// further in than is taken off. It holds whatever the ray did between the two, so any position may
/// be left out: one that has moved by less than 1 mm, that turns back by less than 12 mm (jitter),
/// or that crosses the last one within 3 cm is dropped; beyond, the chain begins anew. Where two
/// rays cross they bound two wedges, and the deeper one is the strip: a ray that turns about its
/// own mount is covered by that.
///
/// A cell is free if, while the ray went from before it to behind it, the cell lay within the depth
/// of every strip on the way; 64 positions are remembered.
class RayStrips {
 public:
  void restart() noexcept { count_ = 0; }

  /// The ray's next position: from `mount` along the unit vector `u`, free for `clearance_m`; NaN
  /// is no position. `body_gap_m` says how deep in the body the mount lies: nothing reaches through
  /// the body. Marks the cells that the ray has passed. O(cells of the strip).
  void advance(Point mount,
               Point u,
               double clearance_m,
               double body_gap_m,
               const StripRule& rule,
               FreeCells& cells) noexcept;

 private:
  static constexpr std::size_t kKept = 64;
  struct Strip {
    Point mount;  // of the ray at the strip's end, and its direction
    Point u;
    Point middle;  // unit vector along which depths count, from the frame's origin
    double near_m = 0.0;
    double far_m = 0.0;
  };
  /// Depths from the last mount along the middle direction.
  struct Span {
    double begin_m = 0.0;
    double end_m = 0.0;
    [[nodiscard]] bool empty() const noexcept { return !(end_m > begin_m); }
  };
  [[nodiscard]] const Strip& strip(std::size_t back) const noexcept {
    return strips_[(newest_ + kKept - back) % kKept];
  }
  void anchor(Point mount, Point u, double clearance_m) noexcept;
  [[nodiscard]] bool passed(Point middle, double half_m) const noexcept;
  void mark_passed(const std::array<Point, 4>& corners, FreeCells& cells) const noexcept;

  std::array<Strip, kKept> strips_{};
  std::size_t newest_ = 0;
  std::size_t count_ = 0;     // of positions kept; the oldest one ends no strip
  double side_ = 0.0;         // +1: the ray moves to its left; 0: not known yet
  double clearance_m_ = 0.0;  // at the newest position
};

}  // namespace tcert::witness
