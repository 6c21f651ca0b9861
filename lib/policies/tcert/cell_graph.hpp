#pragma once
/// \file
/// The cells of a course as D* Lite sees them: 8-connected, inflated by the body, dearer near
/// contacts.

#include <array>
#include <cstdint>
#include <tcert/course_grid.hpp>
#include <tcert/dstar_lite.hpp>
#include <vector>

namespace tcert::policies {

/// A way of length s between two neighbouring cells costs s (1 + k (L_a + L_b)/2), L the level of a
/// cell in eighths; it is closed if either lies within the inflation of an obstacle. What is not
/// known is free at level 0.
///
/// The constructor takes all memory; every other member is noexcept.
class CellGraph {
 public:
  static constexpr std::uint8_t kMostLevel = 8;

  /// \throws std::invalid_argument as CourseGrid.
  explicit CellGraph(const PolicySetup& setup);

  /// All free and level 0, no goal. O(cells).
  void reset() noexcept;

  /// Marks a cell as an obstacle or as none. O(cells within the inflation), if that is new.
  void set_obstacle(std::uint32_t cell, bool obstacle) noexcept;
  void set_level(std::uint32_t cell, std::uint8_t level) noexcept;
  /// A new goal: the search starts anew.
  void set_goal(std::uint32_t cell) noexcept;

  [[nodiscard]] bool is_obstacle(std::uint32_t cell) const noexcept { return obstacle_[cell] != 0; }
  [[nodiscard]] bool is_free(std::uint32_t cell) const noexcept {
    return obstacles_near_[cell] == 0;
  }

  /// Repairs the search; the cost of the cheapest way from `start` to the goal, kBlocked if there
  /// is none. \pre a goal is set.
  PathCost plan(std::uint32_t start) noexcept;

  /// The point on the cheapest way from the cell that was last planned from, `lookahead_m` from its
  /// centre or at the goal. Of ways that cost the same, the one nearest to the straight line to the
  /// goal; of two that mirror each other about that, the one on `side` of it. \pre a plan that is
  /// not kBlocked.
  [[nodiscard]] Point ahead(double lookahead_m, int side) const noexcept;

  [[nodiscard]] const CourseGrid& grid() const noexcept { return grid_; }
  [[nodiscard]] const DStarLite& search() const noexcept { return search_; }

 private:
  static constexpr std::array<GridCell, 8> kNeighbours{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

  void build() noexcept;
  [[nodiscard]] std::uint32_t edge_to(std::uint32_t cell, std::size_t neighbour) const noexcept;
  [[nodiscard]] PathCost cost(std::uint32_t a, std::uint32_t b) const noexcept;
  void renew_edges(std::uint32_t cell) noexcept;
  [[nodiscard]] std::uint32_t next(std::uint32_t cell, int side) const noexcept;

  CourseGrid grid_;
  DStarLite search_;  // state = cell
  double soft_weight_;
  std::vector<GridCell> inflation_;
  std::vector<std::array<std::uint32_t, 4>> edges_;  // to the first four neighbours
  std::vector<std::uint8_t> obstacle_;
  std::vector<std::uint16_t> obstacles_near_;
  std::vector<std::uint8_t> level_;
  std::uint32_t start_ = 0;
  std::uint32_t goal_ = 0;
};

}  // namespace tcert::policies
