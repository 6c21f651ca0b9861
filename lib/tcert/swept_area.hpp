#pragma once
/// \file
/// The area that body and rays have swept: the inner free space F_t of the paper, 2.2.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tcert/parameters.hpp>
#include <tcert/ray_sweep.hpp>
#include <tcert/robot.hpp>
#include <tcert/swept_cells.hpp>
#include <vector>

namespace tcert {

/// How far a piece of the path is from what is not known to be free.
struct SweptClearance {
  double distance_m = 0.0;           ///< At most the longest reach.
  std::optional<SweptCell> nearest;  ///< A nearest cell that is not swept; none within the reach.
};

/// A grid of cells in the frame of the first tick, so that the certificate does not depend on the
/// frame of the log. Whatever is not swept, the open front too, counts as occupied; S and G count
/// as swept. The constructor takes all memory.
class SweptArea {
 public:
  SweptArea(const Robot& robot, const Course& course, const CertificateParameters& parameters);

  /// Forgets the trial; `first` becomes the frame.
  void begin(const Pose& first) noexcept;

  /// The path broke: no ray sweeps across the gap. What was swept stays, for the log's frame does.
  void break_path() noexcept;

  /// Adds what a tick proves: the body's disc, and what the rays have passed since the last one.
  /// `clearances_m` and `bearings_rad` hold one per ray, NaN where a clearance is missing.
  void sweep(const Pose& pose,
             std::span<const double> clearances_m,
             std::span<const double> bearings_rad) noexcept;

  /// Distance of the segment to the nearest cell that is not swept.
  /// O(blocks within the distance).
  [[nodiscard]] SweptClearance clearance(Point from, Point to) noexcept;

  /// True if the cell is swept or lies in S or G.
  [[nodiscard]] bool is_free(SweptCell cell) noexcept;

  [[nodiscard]] bool full() const noexcept { return cells_.full(); }

 private:
  [[nodiscard]] Point local(Point p) const noexcept;
  void mark_body(Point centre) noexcept;
  [[nodiscard]] bool in_course(SweptCell cell) const noexcept;
  struct Piece {
    Point from, to, middle;
    double half_length_m = 0.0;
  };
  void look_into(std::int32_t bx,
                 std::int32_t by,
                 const Piece& piece,
                 SweptClearance& best) noexcept;

  SweepRule rule_;
  double half_diagonal_m_;
  double body_radius_m_;
  double reach_m_ = 0.0;
  std::vector<Ray> rays_;
  std::vector<RaySweep> sweeps_;
  std::array<std::optional<Region>, 2> regions_;        // S and G as given
  std::array<std::optional<Region>, 2> local_regions_;  // in the frame of the first tick
  SweptCells cells_;
  struct CellRun {
    std::int32_t first = 0;
    std::int32_t last = -1;  // below first: no cell
  };
  std::vector<CellRun> body_rows_;  // of the disc that was marked last, and of the one before it
  std::vector<CellRun> last_body_rows_;
  std::int32_t first_body_row_ = 0;
  Pose frame_;
  Point axis_{1.0, 0.0};  // of the frame
};

}  // namespace tcert
