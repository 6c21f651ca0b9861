#pragma once
/// \file
/// T-D*Lite: plans to G over what it has felt, and plans again with every touch.

#include <tcert/cell_graph.hpp>
#include <tcert/certainty_grid.hpp>
#include <tcert/felt_memory.hpp>
#include <tcert/pilot.hpp>
#include <vector>

namespace tcert::policies {

/// Cells whose certainty reaches blocked_certainty are obstacles; the contact memory makes cells
/// near contacts dearer, within two lookaheads of the robot. The core's D* Lite repairs the way to
/// G, and pure pursuit follows it at v_cruise (1 - caution depth). Where a lane would be given up,
/// a cell just ahead is closed for good; where no way is left, all that was felt is forgotten, at
/// most once in 5 s.
///
/// A step in which nothing changes costs what the rays sweep. One plan is bounded by the cells of
/// the grid, which max_policy_cells bounds.
class ReplanningPolicy {
 public:
  /// \throws std::invalid_argument if the setup is out of range, or the course too large for
  /// max_policy_cells.
  explicit ReplanningPolicy(const PolicySetup& setup);

  Command step(const Senses& senses) noexcept;
  void reset() noexcept;
  [[nodiscard]] Pilot& pilot() noexcept { return pilot_; }
  [[nodiscard]] const Pilot& pilot() const noexcept { return pilot_; }

 private:
  void forget() noexcept;
  void take_obstacles() noexcept;
  void take_levels(const Outlook& now) noexcept;
  void close_ahead(const Outlook& now) noexcept;
  [[nodiscard]] std::uint32_t nearest_free(Point p, const Outlook& now) const noexcept;
  [[nodiscard]] Point route_point(const Outlook& now, Point goal) noexcept;
  Command pursue(const Outlook& now, Point target) noexcept;

  Pilot pilot_;
  CertaintyGrid grid_;
  FeltMemory memory_;
  CellGraph graph_;
  double half_width_m_;
  double memory_radius_m_;
  std::uint32_t forget_steps_;  // between two times of forgetting
  std::uint32_t since_forgotten_ = 0;
  std::int32_t rows_;  // of levels, to either side of the robot
  std::int32_t row_ = 0;
  std::vector<GridCell> near_;        // offsets among which a free cell is sought
  std::vector<std::uint8_t> closed_;  // by cell: for good
  std::uint32_t goal_ = CourseGrid::kOutside;
};

}  // namespace tcert::policies
