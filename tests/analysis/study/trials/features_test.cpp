#include "analysis/study/trials/features.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace tcert::study {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr std::int64_t kTick = 100'000'000;

/// A trial built tick by tick: 10 Hz, straight along x, series written down rather than computed.
struct Written {
  Robot robot;
  TickTable ticks;
  std::vector<CertifiedTick> series;

  explicit Written(std::vector<RayKind> kinds = {RayKind::bend}) {
    for (const RayKind kind : kinds) {
      Ray ray;
      ray.name = "r" + std::to_string(robot.rays.size());
      ray.kind = kind;
      ray.reach_m = 2.0;
      robot.rays.push_back(ray);
    }
    ticks.rays = robot.rays.size();
  }

  CertifiedTick& add(double travel_m, double value_m, std::vector<double> readings = {}) {
    const auto k = static_cast<std::int64_t>(ticks.size());
    ticks.time_ns.push_back(7'000'000'000 + k * kTick);
    ticks.poses.push_back({{travel_m, 0.0}, 0.0});
    readings.resize(ticks.rays, 0.0);
    for (const double reading : readings) {
      ticks.readings.push_back({reading, kMissing});
    }
    ticks.stale.push_back(0);
    ticks.segment_start.push_back(0);
    CertifiedTick tick;
    tick.time_ns = ticks.time_ns.back();
    tick.travel_m = travel_m;
    tick.corridor_value_m = value_m;
    tick.certificate_m = -kInf;
    series.push_back(tick);
    return series.back();
  }

  [[nodiscard]] Features features(const EarlyWindowOptions& options = {}) const {
    return early_features(robot, ticks, series, options);
  }
};

TEST(EarlyFeatures, TakesTheSmallerQuantileOfTheTwoWindows) {
  // 0.2 m/s: 15 s end at tick 150 with 3 m, 5 m at tick 250. The value falls by 1 mm a tick, so
  // among ticks 0..150 the lower decile is that of tick 135, among 0..250 that of tick 225.
  Written trial;
  for (int k = 0; k <= 400; ++k) {
    trial.add(k / 50.0, 1.0 - 0.001 * k);
  }
  const Features features = trial.features();
  EXPECT_NEAR(features.tc_landmark.value(), 1.0 - 0.135, 1e-12);
  EXPECT_NEAR(features.tc_early.value(), 1.0 - 0.225, 1e-12);
  EXPECT_EQ(features.ticks_landmark, 151U);
  EXPECT_EQ(features.ticks_early, 151U);
  EXPECT_EQ(features.ticks, 401U);
  EXPECT_DOUBLE_EQ(features.end_s.value(), 40.0);
  EXPECT_DOUBLE_EQ(features.window_end_s.value(), 25.1) << "the first tick beyond 5 m";
  EXPECT_DOUBLE_EQ(features.travel_m.value(), 8.0);

  EarlyWindowOptions landmark_only;
  landmark_only.kind = EarlyWindowKind::landmark;
  EXPECT_EQ(trial.features(landmark_only).tc_early, features.tc_landmark);
  EXPECT_EQ(trial.features(landmark_only).window_end_s, 15.0);
}

TEST(EarlyFeatures, EndsTheDistanceWindowOfAStuckRobotAtTheCap) {
  Written trial;
  for (int k = 0; k <= 1000; ++k) {
    trial.add(std::min(k, 100) / 50.0, 1.0 - 0.001 * k);
  }
  const Features features = trial.features();
  // 601 ticks up to 60 s: the lower decile is that of tick 540.
  EXPECT_NEAR(features.tc_early.value(), 1.0 - 0.540, 1e-12);
  EXPECT_EQ(features.window_end_s, 60.0);
}

TEST(EarlyFeatures, CountsABoundaryTickAsInside) {
  Written trial;
  for (int k = 0; k <= 300; ++k) {
    trial.add(0.02 * k, k == 150 ? -0.5 : 0.5);
  }
  EarlyWindowOptions minimum;
  minimum.quantile = 0.0;
  minimum.kind = EarlyWindowKind::landmark;
  EXPECT_EQ(trial.features(minimum).tc_early, -0.5) << "t = 15 s exactly";
  minimum.time_s = 14.99;
  EXPECT_EQ(trial.features(minimum).tc_early, 0.5);
}

TEST(EarlyFeatures, ReadsTheCertificateOnceThereIsOne) {
  Written trial;
  for (int k = 0; k < 40; ++k) {
    CertifiedTick& tick = trial.add(0.02 * k, 0.1);
    if (k >= 20) {
      tick.certificate_m = 0.3;
      tick.issued = true;
    }
  }
  const Features features = trial.features();
  // Twenty ticks each of 0.1 and 0.3: the decile is 0.1, the median halfway.
  EXPECT_DOUBLE_EQ(features.tc_early.value(), 0.1);
  EarlyWindowOptions median;
  median.quantile = 0.5;
  EXPECT_DOUBLE_EQ(trial.features(median).tc_early.value(), 0.2);
  EXPECT_EQ(features.issued, true);
  EXPECT_DOUBLE_EQ(features.issued_s.value(), 2.0);
  EXPECT_EQ(features.certificate_m, 0.3);
}

TEST(EarlyFeatures, SkipsStaleTicks) {
  Written trial;
  for (int k = 0; k < 30; ++k) {
    CertifiedTick& tick = trial.add(0.02 * k, k % 3 == 0 ? -9.0 : 0.2);
    if (k % 3 == 0) {
      tick.flags = flag_stale;
    }
  }
  const Features features = trial.features();
  EXPECT_DOUBLE_EQ(features.tc_early.value(), 0.2);
  EXPECT_EQ(features.ticks_early, 20U);
}

TEST(EarlyFeatures, IsMissingWithTooFewTicks) {
  Written trial;
  for (int k = 0; k < 9; ++k) {
    trial.add(0.02 * k, 0.2, {0.1 * k});
  }
  Features features = trial.features();
  EXPECT_EQ(features.tc_early, std::nullopt);
  EXPECT_EQ(features.tc_landmark, std::nullopt);
  EXPECT_EQ(features.bend_variance, std::nullopt);
  EXPECT_EQ(features.ticks_early, 9U);
  trial.add(0.2, 0.2);
  features = trial.features();
  EXPECT_TRUE(features.tc_early.has_value());
  EXPECT_TRUE(features.bend_variance.has_value());
}

TEST(EarlyFeatures, IsMissingIfEitherWindowIsTooPoor) {
  // Half a metre a tick: 5 m are over after eleven ticks, of which four are stale.
  Written trial;
  for (int k = 0; k < 100; ++k) {
    trial.add(0.5 * k, 0.2).flags = k < 4 ? flag_stale : 0U;
  }
  const Features features = trial.features();
  EXPECT_EQ(features.ticks_early, 7U);
  EXPECT_EQ(features.tc_early, std::nullopt);
  EXPECT_DOUBLE_EQ(features.tc_landmark.value(), 0.2);
}

TEST(EarlyFeatures, HasNoCertificateFeatureWithoutAPathFromTheStart) {
  Written trial;
  for (int k = 0; k < 100; ++k) {
    trial.add(0.02 * k, k == 50 ? -kInf : 0.2);
  }
  const Features features = trial.features();
  EXPECT_EQ(features.tc_early, std::nullopt);
  EXPECT_EQ(features.certificate_m, std::nullopt);
  EXPECT_EQ(features.issued, false);
  EXPECT_EQ(features.issued_s, std::nullopt);
  EXPECT_TRUE(features.dwell.has_value()) << "the rivals do not need the graph";
}

TEST(EarlyFeatures, NamesATrialThatEndsInsideItsWindow) {
  Written trial;
  for (int k = 0; k <= 150; ++k) {
    trial.add(0.02 * k, 0.2);
  }
  EXPECT_EQ(trial.features().window_end_s, std::nullopt) << "15 s, but not 5 m";
  for (int k = 151; k <= 251; ++k) {
    trial.add(0.02 * k, 0.2);
  }
  EXPECT_TRUE(trial.features().window_end_s.has_value());
}

TEST(EarlyFeatures, CountsContactsPerMetreInTheWorseWindow) {
  // Four contacts in the first 15 s (3 m), then sixteen until 5 m.
  Written trial;
  for (int k = 0; k <= 300; ++k) {
    CertifiedTick& tick = trial.add(k / 50.0, 0.2);
    tick.new_contacts = (k == 10 || k == 90) ? 2U : ((k >= 160 && k < 176) ? 1U : 0U);
  }
  const Features features = trial.features();
  EXPECT_DOUBLE_EQ(features.contacts_per_m_landmark.value(), 4.0 / 3.0);
  EXPECT_DOUBLE_EQ(features.contacts_per_m.value(), 20.0 / 5.0);
}

TEST(EarlyFeatures, HasNoContactsPerMetreWithoutTravel) {
  Written trial;
  for (int k = 0; k < 50; ++k) {
    trial.add(0.0, 0.2).new_contacts = 1;
  }
  EXPECT_EQ(trial.features().contacts_per_m, std::nullopt);
  EXPECT_EQ(trial.features().dwell, 1.0);
}

TEST(EarlyFeatures, MeasuresDwellAsAShareOfTime) {
  // 2 s at 0.2 m/s, then 2 s at rest. Speed is known from tick 5 on; it is below 0.02 m/s once the
  // half second behind holds less than 1 cm: from tick 25 on. So 15 of 35 steps.
  Written trial;
  for (int k = 0; k < 40; ++k) {
    trial.add(std::min(k, 20) / 50.0, 0.2);
  }
  EXPECT_DOUBLE_EQ(trial.features().dwell.value(), 15.0 / 35.0);
}

TEST(EarlyFeatures, SeesARobotThatStandsStillAtTheLandmark) {
  Written standing;
  Written moving;
  for (int k = 0; k <= 200; ++k) {
    standing.add(std::min(k, 140) / 50.0, 0.2);
    moving.add((k < 100 ? 0.0 : k - 100.0) / 50.0, 0.2);
  }
  EXPECT_EQ(standing.features().still_at_landmark, true);
  EXPECT_EQ(moving.features().still_at_landmark, false);
}

TEST(EarlyFeatures, AveragesTheVarianceOverRays) {
  // Bends 0 and 1 in turn, ten each: sum of squares 20 * 0.25, variance 5 / 19. The beam's reach
  // is 2 m, so ranges 1 and 9 are 0.5 and 1: variance 20 * 0.0625 / 19.
  Written trial({RayKind::bend, RayKind::range});
  for (int k = 0; k < 20; ++k) {
    trial.add(0.02 * k, 0.2, {k % 2 == 0 ? 0.0 : 1.0, k % 2 == 0 ? 1.0 : 9.0});
  }
  EXPECT_NEAR(trial.features().bend_variance.value(), (5.0 / 19.0 + 1.25 / 19.0) / 2.0, 1e-14);
}

TEST(EarlyFeatures, LeavesOutARayWithoutReadings) {
  Written trial({RayKind::bend, RayKind::bend});
  for (int k = 0; k < 20; ++k) {
    trial.add(0.02 * k, 0.2, {k % 2 == 0 ? 0.0 : 1.0, kMissing});
  }
  EXPECT_NEAR(trial.features().bend_variance.value(), 5.0 / 19.0, 1e-14);
}

TEST(EarlyFeatures, CutsSharesOfTheWholeTrialWhenAsked) {
  // 40 s, at rest for the first 20 s: a tenth of the time is 4 s, a tenth of the way ends at 22 s.
  Written trial;
  for (int k = 0; k <= 400; ++k) {
    trial.add(k < 200 ? 0.0 : (k - 200) / 50.0, 1.0 - 0.001 * k);
  }
  EarlyWindowOptions fraction;
  fraction.kind = EarlyWindowKind::fraction;
  fraction.quantile = 0.0;
  const Features features = trial.features(fraction);
  EXPECT_NEAR(features.tc_early.value(), 1.0 - 0.220, 1e-12);
  EXPECT_EQ(features.ticks_early, 41U);
}

// Every field by hand: 40 s at 0.2 m/s with a rest from 16 s to 18 s, so that the windows end at 15
// s (151 ticks) and at 5 m, which tick 270 reaches. What is told apart: the two windows, where bend
// and rest fall into the later one alone; and who issues before G.
TEST(EarlyFeatures, AreEachWorkedOutByHand) {
  for (const int goal : {350, 300, 290}) {
    SCOPED_TRACE(goal);
    Written trial;
    double travel_m = 0.0;
    for (int k = 0; k <= 400; ++k) {
      travel_m += k > 0 && (k <= 160 || k > 180) ? 0.02 : 0.0;
      CertifiedTick& tick = trial.add(travel_m, 0.3, {k > 150 && k % 2 == 0 ? 1.0 : 0.0});
      if (k >= 300) {
        tick.certificate_m = k == 310 ? 0.1 : 0.2;
        tick.issued = true;
      }
      tick.flags = k >= goal ? flag_goal_reached : 0U;
    }
    const Features features = trial.features();
    EXPECT_EQ(features.ticks_landmark, 151U);
    EXPECT_EQ(features.ticks_early, 151U);
    EXPECT_NEAR(features.window_end_s.value(), 27.1, 1e-9);
    EXPECT_NEAR(features.travel_m.value(), 7.6, 1e-9);
    EXPECT_EQ(features.bend_variance_landmark, 0.0);
    // 60 ones among 271 ticks.
    EXPECT_NEAR(features.bend_variance.value(), 60.0 * 211.0 / (271.0 * 270.0), 1e-12);
    EXPECT_EQ(features.dwell_landmark, 0.0);
    EXPECT_NEAR(features.dwell.value(), 16.0 / 266.0, 0.5 / 266.0) << "2 s, less half a second";
    EXPECT_EQ(features.still_at_landmark, false);
    EXPECT_EQ(features.issued, true);
    EXPECT_NEAR(features.issued_s.value(), 30.0, 1e-12);
    EXPECT_EQ(features.issued_before_goal, goal > 300);
    EXPECT_EQ(features.certificate_falls, 1U);
    EXPECT_EQ(features.certificate_m, 0.2);
    EXPECT_EQ(features.contacts_per_m, 0.0);
  }
}

TEST(EarlyFeatures, SaysOfAnEmptyLogThatItIsEmpty) {
  const Written trial;
  const Features features = trial.features();
  EXPECT_EQ(features.ticks, 0U);
  EXPECT_EQ(features.end_s, std::nullopt);
  EXPECT_EQ(features.tc_early, std::nullopt);
}

TEST(EarlyFeatures, RefusesASeriesOfAnotherTrial) {
  Written trial;
  trial.add(0.0, 0.2);
  trial.series.clear();
  EXPECT_THROW(static_cast<void>(trial.features()), std::invalid_argument);
}

TEST(EarlyWindowOptions, AreCheckedOneByOne) {
  EXPECT_NO_THROW(validate(EarlyWindowOptions{}));
  EarlyWindowOptions options;
  options.fraction = 0.0;
  EXPECT_THROW(validate(options), std::invalid_argument);
  options = {};
  options.min_ticks = 0;
  EXPECT_THROW(validate(options), std::invalid_argument);
  options = {};
  options.quantile = 1.5;
  EXPECT_THROW(validate(options), std::invalid_argument);
  options = {};
  options.dwell_window_s = std::nan("");
  EXPECT_THROW(validate(options), std::invalid_argument);
}

}  // namespace
}  // namespace tcert::study
