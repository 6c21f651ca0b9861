#include "datasets/corpus/policy.hpp"

#include <array>

namespace tcert {
namespace {

struct Profile {
  double cruise_mps;
  double caution;
  double look_in;
  double pause;
  std::array<double, kLightings> heading_noise_per_m;
};

constexpr std::array<Profile, kAlgorithms> kProfiles{{
    {0.203, 0.15, 0.05, 0.02, {0.10, 0.05, 0.07}},  // CB-V: the camera is worse off in the dark
    {0.182, 0.20, 0.15, 0.05, {0.05, 0.05, 0.05}},  // M1
    {0.125, 0.20, 0.25, 0.10, {0.05, 0.05, 0.05}},  // M2
    {0.141, 0.20, 0.20, 0.08, {0.05, 0.05, 0.05}},  // M3
    {0.192, 0.20, 0.10, 0.05, {0.05, 0.05, 0.05}},  // TD*Lite
    {0.178, 0.20, 0.10, 0.05, {0.05, 0.05, 0.05}},  // TVFH
}};

constexpr std::array<double, kLightings> kSpeedFactor{0.93, 1.07, 0.99};  // Dark, Indoor, Outdoor

}  // namespace

Policy policy_of(Algorithm algorithm, Lighting lighting) noexcept {
  const Profile& profile = kProfiles[static_cast<std::size_t>(algorithm)];
  const auto tier = static_cast<std::size_t>(lighting);
  return {profile.cruise_mps * kSpeedFactor[tier],
          profile.caution,
          profile.look_in,
          profile.pause,
          profile.heading_noise_per_m[tier]};
}

}  // namespace tcert
