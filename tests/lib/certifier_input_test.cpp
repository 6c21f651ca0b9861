#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <tcert/certifier.hpp>

#include "support/random_run.hpp"

namespace tcert {
namespace {

using test_support::random_run;
using RandomRun = test_support::Run;

TEST(Certifier, SkipsAndFlagsWhatIsNoTick) {
  RandomRun run = random_run(4, 100);
  Certifier certifier(run.robot, run.course, {});
  const CertifiedTick good = certifier.update(run.ticks[0]);
  Tick bad = run.ticks[1];
  bad.pose.position.x_m = std::nan("");
  EXPECT_EQ(certifier.update(bad).flags & flag_bad_input, flag_bad_input);
  bad = run.ticks[1];
  bad.time_ns = run.ticks[0].time_ns;
  EXPECT_EQ(certifier.update(bad).flags & flag_bad_input, flag_bad_input);
  bad = run.ticks[1];
  bad.rays = bad.rays.first(1);
  const CertifiedTick skipped = certifier.update(bad);
  EXPECT_EQ(skipped.flags & flag_bad_input, flag_bad_input);
  EXPECT_TRUE(std::isnan(skipped.margin_m));
  EXPECT_EQ(skipped.corridor_value_m, good.corridor_value_m);
  EXPECT_EQ(skipped.nodes, good.nodes);
}

TEST(Certifier, AGapBeforeASkippedTickIsStillABreak) {
  RandomRun run = random_run(4, 3);
  for (Tick& tick : run.ticks) {
    tick.pose = run.ticks[0].pose;
    tick.stale = tick.segment_start = false;
  }
  for (const bool stale : {true, false}) {
    Certifier certifier(run.robot, run.course, {});
    certifier.update(run.ticks[0]);
    Tick skipped = run.ticks[1];
    skipped.segment_start = true;
    skipped.stale = stale;
    skipped.pose.yaw_rad = stale ? 0.0 : std::nan("");
    EXPECT_EQ(certifier.update(skipped).flags & flag_break, 0U);
    EXPECT_EQ(certifier.update(run.ticks[2]).flags & flag_break, flag_break);
  }
}

// Lengths between poses of any size would overflow, and with them the cells of the swept area.
TEST(Certifier, RefusesPosesBeyondAnyPlace) {
  const RandomRun run = random_run(4, 3);
  CertificateParameters parameters;
  parameters.clearance = ClearanceReading::swept;
  Certifier certifier(run.robot, run.course, parameters);
  for (const double far : {-1.5e308, 1.5e308, -1.01e9, 1.01e9}) {
    for (const auto change : {0, 1, 2}) {
      Tick tick = run.ticks[0];
      (change == 0   ? tick.pose.position.x_m
       : change == 1 ? tick.pose.position.y_m
                     : tick.pose.yaw_rad) = far;
      EXPECT_EQ(certifier.update(tick).flags & flag_bad_input, flag_bad_input) << far;
    }
  }
  std::int64_t time_ns = run.ticks[0].time_ns;
  for (const double far : {-1e9, 1e9, 0.0}) {
    Tick tick = run.ticks[0];
    tick.time_ns = time_ns++;
    tick.pose = {{far, -far}, far};
    EXPECT_EQ(certifier.update(tick).flags & flag_bad_input, 0U) << far;
  }
}

TEST(Certifier, RefusesAReadingThatIsFoundAtTheEndOfATrialAlone) {
  CertificateParameters parameters;
  parameters.clearance = ClearanceReading::witness;
  EXPECT_THROW(Certifier({}, {}, parameters), std::invalid_argument);
}

TEST(Certifier, RefusesRulesForObstaclesThatProveNothing) {
  CertificateParameters parameters;
  EXPECT_NO_THROW(validate(parameters));
  parameters.sharpest_corner_rad = 1.58;
  EXPECT_THROW(validate(parameters), std::invalid_argument);
  parameters = {};
  parameters.travel_deadband_m = 1e-6;  // a million steps of the lag
  EXPECT_THROW(validate(parameters), std::invalid_argument);
}

}  // namespace
}  // namespace tcert
