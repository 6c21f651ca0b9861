#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <tcert/certifier.hpp>
#include <tcert/corridor_graph.hpp>
#include <tcert/travel_window.hpp>

#include "support/random_run.hpp"
#include "support/widest_oracle.hpp"

namespace tcert {
namespace {

constexpr double kNoPath = -std::numeric_limits<double>::infinity();
constexpr double kDoorSpeed = 0.05;  // m/s
constexpr double kSpeed = 0.3;       // of the robot
constexpr std::int64_t kTickNs = 100'000'000;

CertificateParameters moving_at(double speed_mps) {
  CertificateParameters parameters;
  parameters.obstacle_speed_mps = speed_mps;
  return parameters;
}

Robot robot_of_two_rays() {
  Robot robot;
  robot.rays = {{"left", {}, 0.5 * std::numbers::pi, 2.0, RayKind::range, {}},
                {"right", {}, -0.5 * std::numbers::pi, 2.0, RayKind::range, {}}};
  return robot;
}

/// A corridor 2 m wide along x with a sliding door from 0.9 to 1.1 m, whose leaf comes from the
/// left at kDoorSpeed from 6 s on, when the robot has passed.
struct DoorWorld {
  double shuts_s = 6.0;
  [[nodiscard]] double gap_m(double time_s) const {
    return std::clamp(1.2 - kDoorSpeed * (time_s - shuts_s), 0.0, 1.2);
  }
  /// T of the corridor as it is now.
  [[nodiscard]] double truth_m(double time_s) const { return gap_m(time_s) - 0.45; }
  [[nodiscard]] std::array<RayReading, 2> feel(double x_m, double time_s) const {
    const bool at_door = x_m >= 0.9 && x_m <= 1.1;
    return {{{at_door ? gap_m(time_s) - 0.6 : 1.0}, {at_door ? 0.6 : 1.0}}};
  }
};

/// From x = 0 to 2 m, then the robot stands in G.
std::vector<CertifiedTick> drive_through(const DoorWorld& world,
                                         const CertificateParameters& parameters,
                                         double end_s = 60.0) {
  const Course course{Disc{{0.0, 0.0}, 0.2}, Disc{{2.0, 0.0}, 0.2}};
  Certifier certifier(robot_of_two_rays(), course, parameters);
  std::vector<CertifiedTick> series;
  for (int k = 0; 0.1 * k <= end_s; ++k) {
    const double time_s = 0.1 * k;
    const double x_m = std::min(kSpeed * time_s, 2.0);
    const auto readings = world.feel(x_m, time_s);
    series.push_back(certifier.update({k * kTickNs, {{x_m, 0.0}, 0.0}, readings}));
  }
  return series;
}

TEST(MovingObstacles, ADoorThatClosesIsNeverCertifiedAndTFallsBeforeItIsShut) {
  const DoorWorld world;
  const std::vector<CertifiedTick> still = drive_through(world, moving_at(0.0));
  const std::vector<CertifiedTick> moving = drive_through(world, moving_at(kDoorSpeed));
  std::size_t issued = 0;
  std::size_t too_much_still = 0;
  double fell_s = 0.0;
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const double time_s = 0.1 * static_cast<double>(k);
    ASSERT_LE(moving[k].certificate_m, world.truth_m(time_s) + 1e-9) << time_s;
    too_much_still += still[k].certificate_m > world.truth_m(time_s) + 1e-9 ? 1 : 0;
    issued += moving[k].certificate_m > 0.0 ? 1 : 0;
    if (moving[k].certificate_m <= 0.0 && fell_s == 0.0 && moving[k].certificate_m > kNoPath) {
      fell_s = time_s;
    }
  }
  EXPECT_GT(issued, 5U) << "T is worth something for a while";
  EXPECT_GT(too_much_still, 50U) << "a static certificate goes on claiming the open door";
  const double too_narrow_s = world.shuts_s + 0.75 / kDoorSpeed;
  EXPECT_LT(fell_s, too_narrow_s) << "before no body fits any more, and so before it is shut";
  EXPECT_TRUE(moving.back().issued);
}

TEST(MovingObstacles, StateForHowLongTHolds) {
  const std::vector<CertifiedTick> series = drive_through({}, moving_at(kDoorSpeed));
  const auto first = std::ranges::find_if(
      series, [](const CertifiedTick& tick) { return tick.certificate_m > 0.0; });
  ASSERT_NE(first, series.end());
  EXPECT_NEAR(first->valid_for_s, first->certificate_m / (2.0 * kDoorSpeed), 1e-12);
  const auto last = std::ranges::find_if(
      first, series.end(), [](const CertifiedTick& tick) { return !(tick.certificate_m > 0.0); });
  EXPECT_NEAR(0.1 * static_cast<double>(last - first), first->valid_for_s, 0.1 + 1e-9);
  EXPECT_TRUE(std::isnan(last->valid_for_s));
  EXPECT_TRUE(std::isnan(drive_through({}, moving_at(0.0)).back().valid_for_s));
}

TEST(MovingObstacles, AnotherPassVerifiesAgain) {
  // Static walls: there and back, and T of the second pass is that of the first again.
  const Course course{Disc{{0.0, 0.0}, 0.3}, Disc{{2.0, 0.0}, 0.3}};
  Certifier certifier(robot_of_two_rays(), course, moving_at(kDoorSpeed));
  const std::array<RayReading, 2> readings{{{0.5}, {0.5}}};
  double first_m = kNoPath;
  double before_m = kNoPath;
  double second_m = kNoPath;
  for (int k = 0; k <= 300; ++k) {
    const double way_m = 0.02 * k;
    const double x_m = way_m <= 2.0 ? way_m : way_m <= 4.0 ? 4.0 - way_m : way_m - 4.0;
    const CertifiedTick now = certifier.update({k * kTickNs, {{x_m, 0.0}, 0.0}, readings});
    if (k == 100) {
      first_m = now.certificate_m;
    }
    before_m = k == 200 ? now.certificate_m : before_m;
    second_m = now.certificate_m;
  }
  EXPECT_GT(first_m, kNoPath);
  // Each leg takes 10 s, 1 m of margin if nothing were felt anew.
  EXPECT_NEAR(before_m, first_m, 0.15);
  EXPECT_NEAR(second_m, first_m, 0.15);
}

TEST(MovingObstacles, AStaleTickIsLaterToo) {
  const DoorWorld world;
  Certifier certifier(
      robot_of_two_rays(), {Disc{{0.0, 0.0}, 0.3}, Disc{{4.0, 0.0}, 0.3}}, moving_at(kDoorSpeed));
  CertifiedTick now;
  for (int k = 0; k <= 200; ++k) {
    const double x_m = std::min(0.02 * k, 4.0);
    const auto readings = world.feel(x_m, 0.0);
    now = certifier.update({k * kTickNs, {{x_m, 0.0}, 0.0}, readings});
  }
  const auto readings = world.feel(4.0, 0.0);
  Tick stale{300 * kTickNs, {{4.0, 0.0}, 0.0}, readings};
  stale.stale = true;
  EXPECT_NEAR(
      certifier.update(stale).certificate_m, now.certificate_m - 10.0 * 2.0 * kDoorSpeed, 1e-9);
}

TEST(MovingObstacles, ATickWithoutAPoseIsLaterTooAndItsTimeIsNotBelieved) {
  const DoorWorld world;
  Certifier certifier(
      robot_of_two_rays(), {Disc{{0.0, 0.0}, 0.3}, Disc{{2.0, 0.0}, 0.3}}, moving_at(kDoorSpeed));
  CertifiedTick now;
  for (int k = 0; k <= 100; ++k) {
    const auto readings = world.feel(0.02 * k, 0.0);
    now = certifier.update({k * kTickNs, {{0.02 * k, 0.0}, 0.0}, readings});
  }
  ASSERT_GT(now.certificate_m, kNoPath);
  const auto readings = world.feel(2.0, 0.0);
  const Tick lost{200 * kTickNs, {{kMissing, 0.0}, 0.0}, readings};
  const CertifiedTick later = certifier.update(lost);
  EXPECT_NE(later.flags & flag_bad_input, 0U);
  EXPECT_NEAR(later.certificate_m, now.certificate_m - 10.0 * 2.0 * kDoorSpeed, 1e-9);
  EXPECT_NEAR(certifier.since_start_m(), 10.0 * 2.0 * kDoorSpeed, 1e-9) << "as of the last tick";
  const Tick again{50 * kTickNs, {{2.0, 0.0}, 0.0}, readings};
  EXPECT_EQ(certifier.update(again).certificate_m, now.certificate_m);
}

/// As of time 0 nothing ever falls, so that T is that of a search from scratch, less what is lost
/// since; and never less than the time there was can cost.
TEST(MovingObstacles, EqualASearchFromScratchAtEveryTick) {
  constexpr double kSlow = 0.01;
  std::size_t connected = 0;
  for (std::uint32_t seed = 0; seed < 30; ++seed) {
    const test_support::Run run = test_support::random_run(seed, 800);
    Certifier still(run.robot, run.course, {});
    Certifier moving(run.robot, run.course, moving_at(kSlow));
    double last_m = kNoPath;
    for (const Tick& tick : run.ticks) {
      const CertifiedTick a = still.update(tick);
      const CertifiedTick b = moving.update(tick);
      const double since_s = moving.since_start_m() / (2.0 * kSlow);
      ASSERT_EQ(a.nodes, b.nodes);
      ASSERT_EQ(a.flags, b.flags);
      ASSERT_LE(b.certificate_m, a.certificate_m) << "nothing that moves makes room";
      ASSERT_TRUE(!(b.margin_m > a.margin_m));
      ASSERT_GE(b.certificate_m, a.certificate_m - 2.0 * kSlow * (since_s + 0.2) - 1e-9);
      if ((b.flags & (flag_stale | flag_bad_input)) == 0) {
        ASSERT_GE(b.certificate_m + moving.since_start_m(), last_m - 1e-12);
        last_m = b.certificate_m + moving.since_start_m();
      }
      if (tick.time_ns % 1'000'000'000 == 0) {
        const bool tied = (b.flags & flag_start_outside) == 0;
        ASSERT_EQ(
            b.certificate_m,
            test_support::certificate_by_search(moving.graph(), tied) - moving.since_start_m());
      }
      connected += a.certificate_m > kNoPath ? 1 : 0;
    }
    if (const auto narrowest = moving.bottleneck()) {
      ASSERT_NEAR(narrowest->margin_m, last_m - moving.since_start_m(), 1e-9);
    }
  }
  EXPECT_GT(connected, 1000U);
}

TEST(MovingObstacles, AreRefusedWhereWhatWasSweptHasNoTime) {
  for (const ClearanceReading clearance : {ClearanceReading::swept, ClearanceReading::witness}) {
    CertificateParameters parameters = moving_at(0.05);
    parameters.clearance = clearance;
    EXPECT_THROW(validate(parameters), std::invalid_argument);
  }
}

TEST(TrailingAged, KeepsTheLeastOfAPlaceAsOfTheNewest) {
  TrailingAged window(1.0, 0.01);
  EXPECT_EQ(window.add(0.0, 0.0, 5.0, 0.0), 5.0);
  EXPECT_EQ(window.add(0.0, 0.01, 7.0, 1.0), 5.0);  // the same place, felt anew: nothing is lost
  EXPECT_EQ(window.add(0.5, 0.0, 9.0, 2.0), 4.0);   // 1 since
  EXPECT_EQ(window.add(0.5, 0.0, 3.5, 2.5), 3.5);
  EXPECT_EQ(window.add(0.5, 0.3, 9.0, 3.0), 3.0);  // turned on the spot: it looks elsewhere
  EXPECT_EQ(window.add(1.2, 0.3, 8.0, 4.0), 2.0);  // the first place has gone, the second not
  EXPECT_EQ(window.add(1.9, 0.3, 8.5, 4.0), 8.0);
}

}  // namespace
}  // namespace tcert
