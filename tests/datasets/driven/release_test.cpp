// Every contact of a tentacle held against the walls: each bound is reasoned from the robot, not
// read off the logs.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "datasets/driven/watched.hpp"

namespace tcert {
namespace {

using namespace driven_test;

constexpr double kPress = 0.004;  // m within reach, at which a tentacle begins to touch
constexpr double kChord = 1e-4;   // m: of the true way from its chord over a control period

/// The true pose at a time within the track, on the straight between two control steps.
Pose truth_at(const std::vector<TrackPoint>& track, std::int64_t time_ns, std::size_t& at) {
  while (at + 2 < track.size() && track[at + 1].time_ns < time_ns) {
    ++at;
  }
  const TrackPoint& a = track[at];
  const TrackPoint& b = track[at + 1];
  const double share =
      static_cast<double>(time_ns - a.time_ns) / static_cast<double>(b.time_ns - a.time_ns);
  return {a.pose.position + share * (b.pose.position - a.pose.position),
          a.pose.yaw_rad + share * angle_between(a.pose.yaw_rad, b.pose.yaw_rad)};
}

double clearance_of(const WallIndex& walls, const Ray& ray, const Pose& pose) {
  return walls.cast(pose.position,
                    transform(pose, ray.mount),
                    direction(pose.yaw_rad + ray.bearing_rad),
                    ray.reach_m + 0.02);
}

// Every tactile sample is cast anew against the walls, from where the body truly was.
TEST(DrivenContacts, ReleaseWithinOneSampleOfTheirWallInEveryTrial) {
  std::size_t touching = 0;
  std::size_t outlived = 0;
  std::size_t unfelt = 0;
  for (const Watched& trial : study()) {
    const WallIndex walls = walls_of(trial.design.world, 0.75);
    const TactileStream& tactile = trial.driven.trial.log.tactile;
    std::size_t at = 0;
    for (std::size_t i = 0; i < tactile.time_ns.size(); ++i) {
      const std::int64_t time = tactile.time_ns[i];
      if (time < trial.track.front().time_ns || time > trial.track.back().time_ns) {
        continue;
      }
      const Pose pose = truth_at(trial.track, time, at);
      for (std::size_t k = 0; k < kTentacles; ++k) {
        const Ray& ray = corpus_robot().rays[k];
        const double clearance = clearance_of(walls, ray, pose);
        const double force = tactile.readings[i * kTentacles + k].fsr_n;
        touching += force >= kContactOff ? 1 : 0;
        // A corner may lie between the ray as cast here and as cast from the body's own steps.
        const Pose near{pose.position, pose.yaw_rad + 1e-3};
        const Pose nearer{pose.position, pose.yaw_rad - 1e-3};
        const double least =
            std::min({clearance, clearance_of(walls, ray, near), clearance_of(walls, ray, nearer)});
        const double most =
            std::max({clearance, clearance_of(walls, ray, near), clearance_of(walls, ray, nearer)});
        outlived += force >= kContactOff && least > ray.reach_m + kChord ? 1 : 0;
        unfelt += force < kContactOff && most < ray.reach_m - kPress - kChord ? 1 : 0;
      }
    }
  }
  std::printf("%zu readings in contact, %zu outlive their wall, %zu walls are not felt\n",
              touching,
              outlived,
              unfelt);
  EXPECT_GT(touching, 10'000U);
  EXPECT_EQ(outlived, 0U);
  EXPECT_EQ(unfelt, 0U);
}

}  // namespace
}  // namespace tcert
