#pragma once
/// \file
/// The local proxies of a tick: clearance to both sides (P1) and turn radius (P2), paper 3.1.

#include <cstdint>
#include <span>
#include <tcert/contact_curvature.hpp>
#include <tcert/contact_memory.hpp>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <tcert/travel_window.hpp>
#include <vector>

namespace tcert {

/// What a tick says about the place where the robot is. Lengths in metres.
struct LocalGeometry {
  double left_m = 0.0;  ///< Free width on the left, trailing minimum.
  double right_m = 0.0;
  double width_m = 0.0;        ///< Free width across the heading, by the clearance reading.
  double turn_radius_m = 0.0;  ///< By the curvature reading; at most 1/min_curvature_per_m.
  std::uint32_t contacts = 0;
  std::uint32_t new_contacts = 0;
  bool missing_ray = false;
  bool across_heading = false;  ///< The robot moves off its heading: its sides count for less.
};

/// Keeps the trailing windows and the contact states of one trial. The constructor takes all
/// memory.
class Proxies {
 public:
  Proxies(const Robot& robot, const CertificateParameters& parameters);

  void clear() noexcept;

  /// Forgets what was felt before here: the path broke.
  void restart_windows() noexcept;

  /// Takes a fresh tick and adds its contacts to `memory`. `travel_m` is the distance travelled,
  /// `time_s` the time since the first tick; inside S turning is no evidence.
  LocalGeometry update(const Tick& tick,
                       double travel_m,
                       double time_s,
                       bool inside_start,
                       ContactMemory& memory) noexcept;

  /// Clearance per ray at the last update, clamped to [0, reach]; NaN where the ray is missing.
  [[nodiscard]] std::span<const double> clearances() const noexcept { return clearance_m_; }

  /// Bearing per ray at the last update.
  [[nodiscard]] std::span<const double> bearings() const noexcept { return bearing_rad_; }

  /// The width that would be read if both sides were free to the reach of the rays that look
  /// there as mounted.
  [[nodiscard]] double reach_width_m() const noexcept { return reach_width_m_; }

  /// The same, where a side to which none is mounted may be felt by one that a joint moves.
  [[nodiscard]] double widest_m() const noexcept { return widest_m_; }

 private:
  struct RayState {
    Ray ray;
    int side = 0;           // +1 left, -1 right, 0 neither
    double offset_m = 0.0;  // of the mount, towards its side
    double across = 0.0;    // |sin bearing|
    Point ahead;            // unit vector of the bearing
    bool in_contact = false;
  };
  /// What a ray that a joint moves felt when it last looked to a side.
  struct Look {
    double side_m = kMissing;
    double travel_m = 0.0;
    double time_s = 0.0;
  };
  void point(RayState& state, double bearing_rad) const noexcept;
  void follow_joint(std::size_t ray, double bearing_rad) noexcept;
  [[nodiscard]] double since_look(Look& look,
                                  double felt_m,
                                  double travel_m,
                                  double time_s) const noexcept;
  [[nodiscard]] bool feels_contact(const RayState& state,
                                   double clearance_m,
                                   double force_n) const noexcept;
  [[nodiscard]] double trailing(TrailingMinimum& still,
                                TrailingAged& moving,
                                double side_m,
                                double travel_m,
                                double time_s) const noexcept;
  [[nodiscard]] double across_both(double left_m, double right_m) const noexcept;
  TrailingMotion::Motion follow(const Pose& pose, double travel_m, bool inside_start) noexcept;
  [[nodiscard]] double along_heading(const TrailingMotion::Motion& moved) const noexcept;
  [[nodiscard]] double path_radius(const TrailingMotion::Motion& moved,
                                   bool inside_start) const noexcept;
  void feel_contact(std::size_t ray,
                    const Tick& tick,
                    double travel_m,
                    double time_s,
                    ContactMemory& memory) noexcept;

  CertificateParameters parameters_;
  double half_width_m_;
  std::vector<RayState> rays_;
  std::vector<double> clearance_m_;
  std::vector<double> bearing_rad_;
  bool moves_ = false;  // a ray has been moved by a joint
  Look left_look_;
  Look right_look_;
  double look_window_m_;
  double reach_width_m_ = 0.0;
  double widest_m_ = 0.0;
  TrailingMinimum left_;
  TrailingMinimum right_;
  TrailingAged left_moving_;  // in their place where obstacles move: as of time 0
  TrailingAged right_moving_;
  TrailingMotion motion_;
  ContactCurvature contact_curvature_;
  double last_yaw_rad_ = 0.0;
  double unwrapped_yaw_rad_ = 0.0;
  bool has_yaw_ = false;
  Pose counted_;  // where travel was counted last
  double counted_m_ = 0.0;
  double across_m_ = 0.0;
};

}  // namespace tcert
