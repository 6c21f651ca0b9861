#pragma once
/// \file
/// Where the rays met something over the last way, for what keeps away from it.

#include <array>
#include <cstddef>
#include <span>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <tcert/travel_window.hpp>
#include <vector>

namespace tcert {

/// Tips of rays whose clearance is short of what they can state by contact_slack_m, over the last
/// body_width_m of travel. Ticks without travel between them replace one another.
///
/// The constructor takes all memory; every other member is noexcept.
class FeltPoints {
 public:
  static constexpr std::size_t kNearest = 8;

  /// Those nearest to a point, nearest first.
  struct Nearest {
    std::array<Point, kNearest> points{};
    std::array<double, kNearest> distances_m{};
    std::size_t count = 0;
  };

  /// \throws std::bad_alloc. \pre robot and parameters are valid.
  FeltPoints(const Robot& robot, const CertificateParameters& parameters);

  void clear() noexcept;

  /// \pre `travel_m` never falls between two clears, a fresh tick.
  void add(const Tick& tick, double travel_m) noexcept;

  /// O(points).
  [[nodiscard]] Nearest nearest(Point to) const noexcept;

  /// How far the body at a pose can go straight on before it meets a point; at most `most_m`.
  /// O(points).
  [[nodiscard]] double free_way_m(const Pose& pose, double most_m) const noexcept;

  /// How far the body's front may go straight on by what the rays within `front_rad` of the heading
  /// read in the last tick: the least of them less half the body width, 0 if no ray looks there.
  [[nodiscard]] double front_m() const noexcept { return front_m_; }

 private:
  /// Of one travel: which points of `points_` are its.
  struct Stop {
    double travel_m = 0.0;
    std::size_t slot = 0;
    std::size_t count = 0;
  };

  std::vector<Ray> rays_;
  std::vector<double> longest_m_;
  double half_width_m_;
  double window_m_;
  double slack_m_;
  std::vector<Stop> stops_;  // a ring
  std::size_t first_ = 0;
  std::size_t size_ = 0;
  std::vector<Point> points_;  // as many for each stop as there are rays
  double front_m_ = 0.0;
};

}  // namespace tcert
