#pragma once
/// \file
/// What has been felt since the last node: the pass along the edge that is being walked.

#include <array>
#include <cstddef>
#include <tcert/corridor_graph.hpp>

namespace tcert {

/// What a fresh tick adds to the edge that is being walked.
struct Evidence {
  Pose pose;
  Point heading;  ///< Unit vector of the pose's yaw.
  double travel_m = 0.0;
  double margin_m = 0.0;  ///< m_t.
  double left_m = 0.0;    ///< Free to the left of the path, trailing minimum.
  double right_m = 0.0;
  double width_m = 0.0;
  double turn_radius_m = 0.0;
  double memory_deduction_m = 0.0;  ///< lambda_M M_t.
  bool in_start = false;
  bool in_goal = false;
  double turn_slack_m = 0.0;  ///< The turn radius' part of m_t, or that of the footing if less.
  /// Where obstacles move: by how much what holds now is above its worth at time 0. Margins of
  /// passes and edges, and labels, are of that time, so that they only rise; 0 else.
  double since_start_m = 0.0;
};

/// Running minimum of the margin, and samples for the profiles: every tick up to a fixed number,
/// then every second, every fourth, ..., so that a robot that stands still costs no memory. Least
/// and largest are exact, the other quantiles are then those of the samples kept.
class PendingPass {
 public:
  void restart(const Evidence& evidence) noexcept;
  void add(const Evidence& evidence) noexcept;

  [[nodiscard]] double margin_m() const noexcept { return pass_.margin_m; }
  /// The least that was free on either side.
  [[nodiscard]] double left_m() const noexcept { return left_m_; }
  [[nodiscard]] double right_m() const noexcept { return right_m_; }

  /// The pass with its profiles (Hyndman-Fan type 7). O(samples log samples).
  [[nodiscard]] Pass finish() noexcept;

 private:
  static constexpr std::size_t kSamples = 128;
  void keep(double width_m, double turn_radius_m) noexcept;

  Pass pass_;
  double left_m_ = 0.0;
  double right_m_ = 0.0;
  std::array<double, kSamples> widths_m_{};
  std::array<double, kSamples> radii_m_{};
  std::size_t kept_ = 0;
  std::size_t stride_ = 1;
  std::size_t seen_ = 0;
};

}  // namespace tcert
