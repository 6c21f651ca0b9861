// What a stranger would expect of the corpus's contacts, before looking: each bound is reasoned
// from the robot and the course, not read off the corpus. What was found stands in its README.

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "datasets/corpus/corpus.hpp"
#include "datasets/corpus/micro_study.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/corpus/trial_course.hpp"
#include "datasets/corpus/wall_index.hpp"

namespace tcert {
namespace {

constexpr double kTouch = 0.3;  // N: far above a free tip's noise, far below a rub
// Poses are logged with 0.8 mm and 2 mrad of noise: five standard deviations of either.
constexpr double kCertain = 0.004;
constexpr double kCertainYaw = 0.010;
constexpr double kPress = 0.004;  // how far within reach a wall is felt
constexpr std::size_t kLateral = 2;

enum Place : std::size_t { gate, lane, crossing, places };
constexpr std::array<const char*, places> kNames{"gate", "lane", "crossing"};

struct Counts {
  std::size_t samples = 0;
  std::size_t touching = 0;

  void add(bool touches) {
    ++samples;
    touching += touches ? 1 : 0;
  }
  void add(const Counts& other) {
    samples += other.samples;
    touching += other.touching;
  }
  [[nodiscard]] double share() const {
    return static_cast<double>(touching) / static_cast<double>(samples);
  }
};

/// Contacts of one log against its own walls.
struct TrialContacts {
  std::array<Counts, places> lateral;  ///< Samples of the left and the right tentacle.
  Counts any;                          ///< Samples of the robot: any of its tentacles.
  Counts each;                         ///< Samples of all three.
  std::size_t outlived = 0;     ///< In contact though no wall was within reach all period long.
  std::size_t unfelt = 0;       ///< Free though a wall was well within reach all period long.
  std::size_t longest_run = 0;  ///< Samples of one contact.
  std::size_t samples = 0;
  std::size_t rays_that_touched = 0;
};

Point mount_of(const Ray& ray, const Pose& pose) { return transform(pose, ray.mount); }

/// Least and largest clearance, without its end at the reach.
struct Clearances {
  double nearest = 10.0;
  double farthest = 0.0;

  void add(const WallIndex& walls, const Ray& ray, const Pose& pose) {
    const double clearance = walls.cast(pose.position,
                                        mount_of(ray, pose),
                                        direction(pose.yaw_rad + ray.bearing_rad),
                                        ray.reach_m + 0.02);
    nearest = std::min(nearest, clearance);
    farthest = std::max(farthest, clearance);
  }
};

Clearances clearances_at(const WallIndex& walls, const Ray& ray, std::span<const Pose> poses) {
  Clearances clearances;
  for (const Pose& pose : poses) {
    clearances.add(walls, ray, pose);
  }
  return clearances;
}

/// From all poses that the logged ones may stand for.
Clearances clearances_near(const WallIndex& walls, const Ray& ray, std::span<const Pose> poses) {
  Clearances clearances;
  for (const Pose& pose : poses) {
    for (const double ahead : {-kCertain, 0.0, kCertain}) {
      for (const double left : {-kCertain, 0.0, kCertain}) {
        for (const double turn : {-kCertainYaw, 0.0, kCertainYaw}) {
          clearances.add(walls, ray, {transform(pose, {ahead, left}), pose.yaw_rad + turn});
        }
      }
    }
  }
  return clearances;
}

/// Where the mount of a lateral tentacle is.
Place place_of(const TrialCourse& course, Point mount) {
  for (const Gate& g : course.gates) {
    const Pose middle = lane_pose(course.course, g.lane, g.along_m);
    const Point off = mount - middle.position;
    const Point ahead = direction(middle.yaw_rad);
    if (std::abs(dot(off, ahead)) <= 0.5 * g.length_m && std::abs(cross(ahead, off)) <= 0.5) {
      return gate;
    }
  }
  return norm(mount) < 0.5 * course.course.lane_width_m ? crossing : lane;
}

TrialContacts contacts_of(const SimulatedTrial& trial, const TrialCourse* course) {
  const WallIndex walls(trial.world, 0.75);
  const TactileStream& tactile = trial.log.tactile;
  const PoseStream& pose = trial.log.pose;
  const Robot& robot = corpus_robot();
  TrialContacts contacts;
  std::array<std::size_t, kTentacles> runs{};
  std::array<bool, kTentacles> touched{};
  for (std::size_t i = 0; i < tactile.time_ns.size(); ++i) {
    const auto after =
        std::upper_bound(pose.time_ns.begin(), pose.time_ns.end(), tactile.time_ns[i]);
    const auto at = static_cast<std::size_t>(after - pose.time_ns.begin());
    const std::size_t first = at < 2 ? 0 : at - 2;
    const std::size_t last = std::min(at + 1, pose.poses.size() - 1);
    const auto poses = std::span(pose.poses).subspan(first, last + 1 - first);
    bool any = false;
    for (std::size_t k = 0; k < kTentacles; ++k) {
      const Ray& ray = robot.rays[k];
      const bool touches = tactile.readings[kTentacles * i + k].fsr_n > kTouch;
      const Clearances seen = clearances_at(walls, ray, poses);
      if (touches && seen.nearest > ray.reach_m) {
        contacts.outlived += clearances_near(walls, ray, poses).nearest > ray.reach_m ? 1 : 0;
      } else if (!touches && seen.farthest < ray.reach_m - kPress) {
        contacts.unfelt +=
            clearances_near(walls, ray, poses).farthest < ray.reach_m - kPress ? 1 : 0;
      }
      runs[k] = touches ? runs[k] + 1 : 0;
      contacts.longest_run = std::max(contacts.longest_run, runs[k]);
      touched[k] = touched[k] || touches;
      any = any || touches;
      contacts.each.add(touches);
      if (course != nullptr && k < kLateral) {
        const Point mount = mount_of(robot.rays[k], pose.poses[std::min(at, last)]);
        contacts.lateral[place_of(*course, mount)].add(touches);
      }
    }
    contacts.any.add(any);
  }
  contacts.samples = tactile.time_ns.size();
  contacts.rays_that_touched = static_cast<std::size_t>(std::ranges::count(touched, true));
  return contacts;
}

struct Study {
  std::vector<TrialDesign> designs;
  std::vector<TrialContacts> contacts;
};

const Study& default_study() {
  static const Study kStudy = [] {
    Study study;
    study.designs = design_block({}, 0);
    study.contacts.resize(study.designs.size());
    tbb::parallel_for(std::size_t{0}, study.designs.size(), [&](std::size_t i) {
      const TrialCourse course = draw_course(study.designs[i]);
      study.contacts[i] = contacts_of(simulate_trial(study.designs[i]), &course);
    });
    return study;
  }();
  return kStudy;
}

/// Over the trials that `take` takes.
template <class Take>
TrialContacts pooled(Take take) {
  TrialContacts sum;
  const Study& study = default_study();
  for (std::size_t i = 0; i < study.designs.size(); ++i) {
    const TrialContacts& one = study.contacts[i];
    if (!take(study.designs[i])) {
      continue;
    }
    for (std::size_t place = 0; place < places; ++place) {
      sum.lateral[place].add(one.lateral[place]);
    }
    sum.any.add(one.any);
    sum.each.add(one.each);
    sum.outlived += one.outlived;
    sum.unfelt += one.unfelt;
  }
  return sum;
}

const auto kAll = [](const TrialDesign&) { return true; };
const auto kSuccesses = [](const TrialDesign& design) { return design.success; };

TEST(CorpusContacts, EndWithinOneSampleOfTheirWall) {
  const TrialContacts all = pooled(kAll);
  EXPECT_EQ(all.outlived, 0U) << "of " << all.each.touching << " samples in contact";
}

TEST(CorpusContacts, BeginWithinOneSampleOfTheirWall) {
  const TrialContacts all = pooled(kAll);
  EXPECT_EQ(all.unfelt, 0U) << "of " << all.each.samples << " samples";
}

TEST(CorpusContacts, EndWithinOneSampleAtNativeRatesAndInTheMicroStudy) {
  CorpusOptions options;
  options.native_rates = true;
  for (const std::uint64_t index : {0U, 100U, 200U, 300U}) {
    const TrialContacts contacts =
        contacts_of(simulate_trial(design_trial(options, index)), nullptr);
    EXPECT_EQ(contacts.outlived, 0U) << index;
    EXPECT_GT(contacts.each.touching, 100U) << index;
  }
  for (std::uint64_t index = 0; index < kGatePasses; index += 7) {
    const TrialContacts contacts = contacts_of(simulate_gate_pass(1, index), nullptr);
    EXPECT_EQ(contacts.outlived, 0U) << index;
    EXPECT_EQ(contacts.unfelt, 0U) << index;
    EXPECT_GE(contacts.rays_that_touched, 2U) << index;  // its one gate is felt on both sides
  }
}

// Place of the mount of a lateral tentacle. A gate is at most 0.45 + 0.3 m wide, so its jaws are
// within 0.3 m of a mount: both tentacles touch, except where they look past a jaw. On a bend of
// 0.6 to 1.0 m a mount 0.16 m ahead looks askew by 9 to 15 degrees, past a jaw 0.2 m away by some
// 4 cm of 10 to 20: a quarter is missed. Lanes of 1.2 m are made to feel free (0.48 m from either
// mount, reach 0.45 m): contact only where a narrow day, a bend or a look to the side brings a wall
// nearer, so in less than a quarter. Within half a lane of the middle of the crossing the nearest
// wall is an outer one, 0.6 m away: hardly ever. Contact of any tentacle is what remains: the
// gates, a fifteenth of the way at 0.8 of the speed and felt on either side of it, and a share of
// the lanes; a tenth to a third of the samples.
TEST(CorpusContacts, AreWhereTheWallsAre) {
  const TrialContacts all = pooled(kSuccesses);
  for (std::size_t place = 0; place < places; ++place) {
    std::printf("%-9s %8zu samples of the lateral tentacles, %5.2f %% in contact\n",
                kNames[place],
                all.lateral[place].samples,
                100.0 * all.lateral[place].share());
  }
  std::printf("any of the three tentacles in contact: %5.2f %%; of all their samples %5.2f %%\n",
              100.0 * all.any.share(),
              100.0 * all.each.share());
  EXPECT_GT(all.lateral[gate].share(), 0.70);
  EXPECT_LT(all.lateral[lane].share(), 0.25);
  EXPECT_LT(all.lateral[crossing].share(), 0.05);
  EXPECT_GT(all.any.share(), 0.10);
  EXPECT_LT(all.any.share(), 0.33);
}

// No tentacle of a success stays in contact for half of its run.
TEST(CorpusContacts, DoNotLast) {
  const Study& study = default_study();
  for (std::size_t i = 0; i < study.designs.size(); ++i) {
    if (study.designs[i].success) {
      EXPECT_LT(2 * study.contacts[i].longest_run, study.contacts[i].samples) << i;
    }
  }
}

}  // namespace
}  // namespace tcert
