#pragma once
/// \file
/// What each ray of a robot says in one step, in the frame of the body.

#include <span>
#include <tcert/mirror_exact.hpp>
#include <tcert/parameters.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert::policies {

/// A direction in which something is felt, or seen. NaN is missing.
struct FeltRay {
  Point mount;                    ///< In the body frame.
  Point ahead;                    ///< Unit vector of the bearing.
  double clearance_m = kMissing;  ///< From the mount, in [0, reach].
  double depth = kMissing;        ///< Share of the reach that is taken: 0 free, 1 at the mount.
  double force_n = kMissing;
  bool contact = false;

  [[nodiscard]] Point tip() const noexcept { return mount + clearance_m * ahead; }
};

/// Bearing of a ray in this tick, from the heading: where its joint pointed, else that of its
/// mount.
[[nodiscard]] double ray_bearing(const Ray& ray, const RayReading& reading) noexcept;

/// Reads the rays of one trial. A contact begins at a tip force of contact_on_n and ends below
/// contact_off_n; without a force, it is a clearance short of the reach by contact_slack_m.
///
/// The constructor takes all memory; every other member is noexcept.
class RayReader {
 public:
  RayReader(const Robot& robot, const CertificateParameters& parameters);

  void reset() noexcept;

  /// One entry a ray, in the order of the robot; valid until the next call. A reading that is not
  /// there is missing, one too many is not looked at.
  std::span<const FeltRay> read(std::span<const RayReading> readings) noexcept;

 private:
  std::vector<Ray> rays_;  // reach_m is the longest clearance that each can state
  std::vector<FeltRay> felt_;
  double contact_on_n_;
  double contact_off_n_;
  double contact_slack_m_;
};

/// Sum over the rays of value(i) K(phi), K = max(0, cos phi), phi from the unit vector `heading` of
/// the body frame to ray i; a value of NaN counts as no ray. The order of the rays does not matter.
/// \pre |value| < 2^7.
template <typename Value>
[[nodiscard]] double kernel_sum(Point heading,
                                std::span<const FeltRay> rays,
                                Value value) noexcept {
  double sum = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const double along = dot(heading, rays[i].ahead);
    const double term = value(i) * (along > 0.0 ? along : 0.0);
    sum += std::isnan(term) ? 0.0 : exact_term(term);
  }
  return sum;
}

/// The largest depth; 0 if none is known, for nothing is felt then.
[[nodiscard]] double deepest(std::span<const FeltRay> rays) noexcept;

/// By how much more is felt on the left than on the right: the sum of depth times sin(bearing).
[[nodiscard]] double left_excess(std::span<const FeltRay> rays) noexcept;

/// The largest force of a ray whose bearing has a cosine of at least `least_cosine`; NaN if none.
[[nodiscard]] double frontal_force(std::span<const FeltRay> rays, double least_cosine) noexcept;

}  // namespace tcert::policies
