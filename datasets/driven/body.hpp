#pragma once
/// \file
/// The stepped body: a round unicycle that walls stop, and the force with which they do.

#include <array>
#include <cstddef>
#include <span>
#include <tcert/geometry.hpp>
#include <tcert/senses.hpp>

#include "datasets/corpus/wall_index.hpp"
#include "datasets/driven/contact.hpp"
#include "datasets/driven/drive_parameters.hpp"
#include "datasets/driven/relief.hpp"

namespace tcert {

/// A quantity that follows its command at a limited rate.
class RateLimited {
 public:
  /// Mean over the next `seconds` on the way to `target` at `rate` > 0 per second; exact, so that
  /// two halves of a step give what the whole does.
  double advance(double target, double rate, double seconds) noexcept;
  [[nodiscard]] double value() const noexcept { return value_; }

 private:
  double value_ = 0.0;
};

/// What the walls do to the body.
struct Hold {
  double force_n = 0.0;  ///< 0: nothing touches.
  Point towards;         ///< Unit vector from the body's middle into the wall, or between two.
};

/// A disc that turns and drives as commanded, within limits on both and on their rates, and that no
/// wall lets in.
///
/// The legs tread on at their speed, whatever holds the body: what walls take of that velocity, its
/// part into them, they take with a force of contact_damping per m/s and standing_force_n on top.
/// Force so grows with speed, is the same for any step, and lasts as long as the push. Between
/// walls on both sides nothing is left of a velocity into the gap: the body is wedged until it is
/// driven another way. Friction takes friction times the force off the speed along the wall.
///
/// No motion enters a wall, however narrow the gap: see contact.hpp. noexcept, allocates nothing.
class Body {
 public:
  /// `walls` and `relief` outlive the body; walls within kSensingRange are known. \pre `start` is
  /// free.
  Body(const DriveParameters& parameters,
       const WallIndex& walls,
       double radius_m,
       const Pose& start,
       std::span<const ReliefPatch> relief = {}) noexcept;

  /// \pre seconds > 0, and a step of the largest speed is shorter than kSensingRange less the
  /// radius. A command that is not finite is one to stand.
  void advance(double seconds, const policies::Command& command) noexcept;

  [[nodiscard]] const Pose& pose() const noexcept { return pose_; }
  /// Of the last step: along the heading, negative in reverse, and of the way in any direction.
  [[nodiscard]] double forward_mps() const noexcept { return forward_mps_; }
  [[nodiscard]] double speed_mps() const noexcept { return speed_mps_; }
  [[nodiscard]] const Hold& hold() const noexcept { return hold_; }
  [[nodiscard]] double travelled_m() const noexcept { return travelled_m_; }
  /// Share of the legs' way that the ground took in the last step; NaN while they hardly tread or a
  /// wall holds the body.
  [[nodiscard]] double slip() const noexcept { return slip_; }

 private:
  [[nodiscard]] Point held_back(Point velocity, double seconds) noexcept;
  void look_around(Point velocity, double seconds) noexcept;
  [[nodiscard]] Hold hold_by(Point taken) const noexcept;

  static constexpr std::size_t kMostContacts = 32;

  DriveParameters parameters_;
  const WallIndex& walls_;
  double radius_m_;
  std::span<const ReliefPatch> relief_;
  double slip_ = kMissing;
  Pose pose_;
  RateLimited speed_;
  RateLimited yaw_rate_;
  double forward_mps_ = 0.0;
  double speed_mps_ = 0.0;
  double travelled_m_ = 0.0;
  double clear_m_ = 0.0;  ///< No wall is nearer to the body than this.
  Hold hold_;

  /// Of the walls within a step's reach: as they lie now, which no motion may enter; and those that
  /// are touched in this step, as they lie then, which is what the force comes from.
  std::array<Contact, kMostContacts> near_{};
  std::array<Contact, kMostContacts> touched_{};
  std::size_t near_count_ = 0;
  std::size_t touched_count_ = 0;
  bool crowded_ = false;  ///< There are more than there is room for: the body stays where it is.
};

}  // namespace tcert
