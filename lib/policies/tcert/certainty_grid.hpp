#pragma once
/// \file
/// How certain a policy is that a cell holds an obstacle: the histogram grid of Borenstein and
/// Koren (1991), with touches in the place of sonar.

#include <cstdint>
#include <span>
#include <tcert/course_grid.hpp>
#include <tcert/pilot.hpp>
#include <vector>

namespace tcert::policies {

/// Certainties from 0 to 15. In each step a contact adds 3 to its cell, and every cell loses 1 that
/// a ray passes without contact or that the body covers.
///
/// The constructor takes all memory; every other member is noexcept.
class CertaintyGrid {
 public:
  static constexpr std::uint8_t kMost = 15;
  static constexpr std::uint8_t kContact = 3;

  /// \throws std::invalid_argument as CourseGrid.
  explicit CertaintyGrid(const PolicySetup& setup);

  void reset() noexcept;

  /// O(cells along the rays and below the body). \pre `now` is whole.
  void take(const Outlook& now) noexcept;

  [[nodiscard]] const CourseGrid& grid() const noexcept { return grid_; }
  /// By the index of a cell.
  [[nodiscard]] std::span<const std::uint8_t> certainties() const noexcept { return certainty_; }
  /// Indices of the cells that the last step touched; one may stand there more than once.
  [[nodiscard]] std::span<const std::uint32_t> touched() const noexcept {
    return std::span(touched_).first(touched_count_);
  }

 private:
  void lower(std::uint32_t cell) noexcept;
  void raise(std::uint32_t cell) noexcept;
  void touch(std::uint32_t cell) noexcept;
  void sweep(const BodyFrame& body, const FeltRay& ray) noexcept;
  [[nodiscard]] std::uint32_t index_at(Point p) const noexcept {
    return grid_.index(grid_.cell_at(p));
  }

  CourseGrid grid_;
  std::vector<std::uint8_t> certainty_;
  std::vector<GridCell> body_;  // offsets of cells that the body covers
  std::vector<std::uint32_t> touched_;
  std::size_t touched_count_ = 0;
};

}  // namespace tcert::policies
