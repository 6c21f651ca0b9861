#pragma once
/// \file
/// Where on the course line a robot is, and the point ahead on it that it aims at.

#include <tcert/course_line.hpp>
#include <vector>

namespace tcert::policies {

/// Follows the lanes of one lobe after another. Where a lane is given up, it leads back to where
/// the lane began and into the next lane of the lobe, in turn.
///
/// The constructor takes all memory; every other member is noexcept.
class LineFollower {
 public:
  /// \pre a valid line, a lookahead above 0.
  LineFollower(const CourseLine& line, double lookahead_m);

  void reset() noexcept;

  /// The point `lookahead` ahead of the one nearest to `position`; beyond the last lobe `goal`. The
  /// nearest is sought within two lookaheads of the one before, for lanes come close to each other.
  /// O(way-points within that).
  [[nodiscard]] Point carrot(Point position, Point goal) noexcept;

  /// Takes the other lane of this lobe. Nothing, where it has only one or is on the way back.
  void give_up_lane() noexcept;

  [[nodiscard]] std::size_t lobe() const noexcept { return lobe_; }
  [[nodiscard]] std::size_t lane() const noexcept { return lane_; }
  [[nodiscard]] bool backing_out() const noexcept { return next_lane_ != lane_; }

 private:
  struct Line {
    std::vector<Point> points;
    std::vector<double> along_m;  // of each point, from the first
  };
  [[nodiscard]] static Point point_at(const Line& line, double along_m) noexcept;
  [[nodiscard]] double nearest_along(const Line& line, Point position) const noexcept;
  void advance(Point position) noexcept;

  std::vector<std::vector<Line>> lobes_;
  double lookahead_m_;
  std::size_t lobe_ = 0;
  std::size_t lane_ = 0;
  std::size_t next_lane_ = 0;  // another than lane_ on the way back
  double along_m_ = 0.0;       // on the lane, from its beginning
};

}  // namespace tcert::policies
