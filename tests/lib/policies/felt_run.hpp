#pragma once
/// \file
/// Random runs of a robot under a policy, and the same runs seen in a mirror.

#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <tcert/policy.hpp>
#include <vector>

namespace tcert::policies {

inline constexpr std::array<PolicyKind, kPolicies> kAllPolicies{PolicyKind::m1,
                                                                PolicyKind::m2,
                                                                PolicyKind::m3,
                                                                PolicyKind::tvfh,
                                                                PolicyKind::td_star_lite,
                                                                PolicyKind::cb_v};

[[nodiscard]] inline bool same_bits(const Command& a, const Command& b) noexcept {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.speed_mps) == bits(b.speed_mps) && bits(a.yaw_rate_rps) == bits(b.yaw_rate_rps);
}

/// Eight rays: left, right, both at 45 degrees, ahead, behind, and a beam without a force sensor on
/// each side; body 0.45 m. Two lobes of two lanes in a box that is not symmetric.
[[nodiscard]] PolicySetup two_lobes();

/// The setup in a mirror: y of everything negated, rays of the two sides in each other's place.
[[nodiscard]] PolicySetup mirrored(const PolicySetup& setup);

/// What a body feels that drives as it is told, now and then is held fast, and whose senses are
/// drawn: depths and forces from a few distinct values so that they tie, missing readings, stale
/// ticks, bumps, sightings. The pose is that of the commands, with noise; in the box.
class FeltRun {
 public:
  /// `wild` also draws NaN, infinities and numbers far out of range into everything.
  FeltRun(std::uint32_t seed, std::size_t rays, bool wild = false);

  /// The senses of the next step, after `last` was commanded. Valid until the next call.
  const Senses& next(const Command& last);

  /// The same senses in the mirror.
  const Senses& mirrored_senses();

 private:
  double uniform(double low, double high);
  bool happens(double probability) { return uniform(0.0, 1.0) < probability; }
  double spoilt(double value);
  void move(const Command& last);
  void feel();
  void see();

  std::mt19937 engine_;
  bool wild_;
  Senses senses_;
  Senses mirrored_;
  Pose pose_;
  int held_ = 0;  // steps
  std::vector<RayReading> readings_;
  std::vector<RayReading> mirrored_readings_;
  std::vector<Sighting> sightings_;
  std::vector<Sighting> mirrored_sightings_;
};

}  // namespace tcert::policies
