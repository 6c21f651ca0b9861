#include "analysis/study/rays/ray_calibration.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <table/random.hpp>
#include <vector>

#include "analysis/study/coverage/ray_study.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/corpus/wall_index.hpp"

namespace tcert::study {
namespace {

RayPairs days(std::size_t count) { return coverage::simulate_ray_days(0, count, 7, 1); }

TEST(DaysOfBound, AreHalfOrAsManyAsAlphaNeedsAndLeaveOneForTheCurves) {
  EXPECT_EQ(days_of_bound(19, 0.05), 0U);
  EXPECT_EQ(days_of_bound(20, 0.05), 19U);
  EXPECT_EQ(days_of_bound(22, 0.05), 19U);
  EXPECT_EQ(days_of_bound(60, 0.05), 30U);
  EXPECT_EQ(days_of_bound(10, 0.1), 9U);
  EXPECT_EQ(days_of_bound(1, 0.5), 0U);
  EXPECT_EQ(days_of_bound(2, 0.5), 1U);
}

TEST(CalibrateRays, KeepsTheDaysOfTheBoundOutOfTheCurves) {
  const RayPairs pairs = days(22);
  const RayCalibration made = calibrate_rays(pairs, {}).calibration.value();
  std::set<std::string> fitted(made.fitted.begin(), made.fitted.end());
  EXPECT_EQ(fitted.size(), 3U);
  ASSERT_EQ(made.bound->days.size(), 19U);
  for (const DayScore& day : made.bound->days) {
    EXPECT_FALSE(fitted.contains(day.day));
  }
  // The same from the fitted days alone.
  for (std::uint32_t ray = 0; ray < 2; ++ray) {
    std::vector<double> bend;
    std::vector<double> clearance;
    for (const RayPair& pair : pairs.pairs) {
      if (pair.ray == ray && fitted.contains(pairs.days[pair.day])) {
        bend.push_back(pair.bend_rad);
        clearance.push_back(pair.clearance_m);
      }
    }
    const RayCurve alone = fit_ray_curve(bend, clearance, 12);
    EXPECT_EQ(made.curves[ray].calibration.bend_rad, alone.calibration.bend_rad);
    EXPECT_EQ(made.curves[ray].calibration.clearance_m, alone.calibration.clearance_m);
  }
}

TEST(CalibrateRays, BoundsTheWorstOfADayOverAllItsRaysAndTicks) {
  const RayPairs pairs = days(50);
  RayCalibrationOptions options;
  options.alpha = 0.1;
  const RayCalibration made = calibrate_rays(pairs, options).calibration.value();
  const RayBound& bound = made.bound.value();
  ASSERT_EQ(bound.days.size(), 25U);
  EXPECT_EQ(bound.rank, 24U);
  std::size_t held = 0;
  for (const DayScore& day : bound.days) {
    double worst = -1e9;
    bool covered = true;
    for (const RayPair& pair : pairs.pairs) {
      if (pairs.days[pair.day] == day.day) {
        const double curve = calibrated_clearance(made.curves[pair.ray].calibration, pair.bend_rad);
        worst = std::max(worst, curve - pair.clearance_m);
        covered = covered && calibrated_clearance(made.usable[pair.ray], pair.bend_rad) <=
                                 pair.clearance_m + 1e-12;
      }
    }
    EXPECT_EQ(day.score_m, worst);
    held += covered ? 1 : 0;
  }
  EXPECT_TRUE(std::ranges::is_sorted(bound.days, {}, &DayScore::score_m));
  EXPECT_EQ(bound.quantile_m, bound.days[23].score_m);
  EXPECT_EQ(held, 24U) << "all of its days but the ones above the quantile";
  EXPECT_GT(bound.pairs_above, 0.99);
}

TEST(CalibrateRays, DealsOutDaysByTheSeedAloneWhateverWasMeasured) {
  RayPairs pairs = days(30);
  const auto fitted = [&](std::uint64_t seed) {
    RayCalibrationOptions options;
    options.seed = seed;
    return calibrate_rays(pairs, options).calibration->fitted;
  };
  const auto first = fitted(1);
  EXPECT_NE(fitted(2), first);
  for (RayPair& pair : pairs.pairs) {
    pair.clearance_m *= 2.0;
  }
  EXPECT_EQ(fitted(1), first);
}

TEST(CalibrateRays, SaysHowManyDaysItNeedsAndWhichAlphaIsPossible) {
  const RayCalibrationResult few = calibrate_rays(days(11), {});
  EXPECT_FALSE(few.calibration);
  EXPECT_EQ(few.problem,
            "11 days, and a bound at alpha 0.05 needs 20: 19 to bound and one to fit; with 11 days "
            "--alpha 0.091 is possible; --no-bound gives the curve alone");
  RayCalibrationOptions possible;
  possible.alpha = 0.091;
  EXPECT_TRUE(calibrate_rays(days(11), possible).calibration);
  EXPECT_EQ(calibrate_rays(days(1), {}).problem,
            "1 day, and a bound at alpha 0.05 needs 20: 19 to bound and one to fit; --no-bound "
            "gives the curve alone");
  RayCalibrationOptions plain;
  plain.bound = false;
  const RayCalibration curve = calibrate_rays(days(2), plain).calibration.value();
  EXPECT_FALSE(curve.bound);
  EXPECT_EQ(curve.fitted.size(), 2U);
  EXPECT_EQ(curve.usable[0].clearance_m, curve.curves[0].calibration.clearance_m);
}

TEST(CalibrateRays, NamesARayThatTheDaysOfTheCurvesLack) {
  RayPairs pairs = days(20);
  pairs.rays.push_back("rear");
  pairs.pairs.push_back({2, 0, 0.5, 0.2});
  bool named = false;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RayCalibrationOptions options;
    options.seed = seed;
    const RayCalibrationResult result = calibrate_rays(pairs, options);
    if (!result.calibration) {
      named = true;
      EXPECT_TRUE(result.problem.starts_with("ray 'rear' has no pair")) << result.problem;
    }
  }
  EXPECT_TRUE(named);
}

/// What the synthetic corpus' tentacles felt of walls at known distances gives back the calibration
/// that they were made with, within their noise (5 to 8 mm, texture among it) and the days' bias.
TEST(CalibrateRays, GivesTheCorpusItsOwnCalibrationBack) {
  World world;
  world.name = "walls";
  world.bounds = {{-1.0, -3.0}, {60.0, 3.0}};
  for (int i = 0; i < 59; ++i) {
    // Teeth on both sides and ahead: every clearance from 0 to the reach and beyond.
    const double x = i;
    const double y = 0.57 + 0.03 * std::sin(0.7 * x);
    world.obstacles.push_back(
        Polygon{{{x, y}, {x + 1.0, y - 0.45}, {x + 1.0, y + 0.3}, {x, y + 0.3}}});
    world.obstacles.push_back(
        Polygon{{{x, -y}, {x, -y - 0.3}, {x + 1.0, -y - 0.3}, {x + 1.0, -y + 0.45}}});
  }
  const WallIndex walls(world, 1.0);
  RayPairs pairs;
  pairs.rays = {"front", "left", "right"};
  table::RandomStream random(2, 1, 1);
  for (std::uint32_t day = 0; day < 24; ++day) {
    pairs.days.push_back("d" + std::to_string(day));
    TentacleSensors sensors(0.004 * random.normal(), table::RandomStream(2, 2, day));
    for (int tick = 0; tick < 400; ++tick) {
      const Pose pose{{1.0 + 0.13 * tick, 0.0}, 0.0};
      const auto clearance = cast_tentacles(walls, pose);
      const auto readings = sensors.read(walls, pose, 0.2);
      for (std::uint32_t side = 0; side < 2; ++side) {  // left and right
        pairs.pairs.push_back({side + 1, day, readings[side].value, clearance[side]});
      }
      pairs.pairs.push_back({0, day, readings[2].value, clearance[2]});
    }
  }
  RayCalibrationOptions plain;
  plain.bound = false;
  const RayCalibration curve = calibrate_rays(pairs, plain).calibration.value();
  for (const std::size_t side : {1U, 2U}) {
    double squares = 0.0;
    int points = 0;
    for (int i = 10; i <= 110; ++i) {
      const double bend = 0.01 * i;
      const double error = calibrated_clearance(curve.curves[side].calibration, bend) -
                           calibrated_clearance(corpus_robot().rays[side - 1].calibration, bend);
      EXPECT_LT(std::abs(error), 0.016) << bend << ": twice the noise of the noisiest tentacle";
      squares += error * error;
      ++points;
    }
    EXPECT_LT(std::sqrt(squares / points), 0.005) << "of all but the ends";
    EXPECT_EQ(curve.curves[side].trend, statistics::Trend::falling);
    EXPECT_LE(curve.curves[side].calibration.bend_rad.size(), 12U);
  }
  const RayBound bound = calibrate_rays(pairs, {}).calibration->bound.value();
  EXPECT_GT(bound.quantile_m, 0.01) << "the worst of thousands of ticks is beyond the noise";
  EXPECT_LT(bound.quantile_m, 0.45) << "and within the reach";
}

}  // namespace
}  // namespace tcert::study
