#include "analysis/study/h3/pareto.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tcert::study {
namespace {

TEST(ParetoFront, KeepsWhatNothingBeats) {
  // (0.3, 1.0) and (0.5, 0.9) are a choice; (0.2, 0.95) and (0.5, 0.8) are beaten.
  const std::vector<GainAndRetention> points{{0.3, 1.0}, {0.2, 0.95}, {0.5, 0.9}, {0.5, 0.8}};
  EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, false, true, false}));
}

TEST(ParetoFront, EqualPointsStandTogether) {
  const std::vector<GainAndRetention> points{{0.3, 1.0}, {0.3, 1.0}, {0.3, 0.9}};
  EXPECT_EQ(pareto_front(points), (std::vector<bool>{true, true, false}));
}

TEST(ParetoFront, WhatIsNotKnownIsOnNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<GainAndRetention> points{{nan, 1.0}, {0.1, 0.5}};
  EXPECT_EQ(pareto_front(points), (std::vector<bool>{false, true}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(ParetoFront, EveryOtherPointIsBeatenByOneOnIt) {
  std::mt19937 random(1);
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::vector<GainAndRetention> points;
    for (int i = 0; i < 12; ++i) {
      points.push_back({static_cast<double>(random() % 6), static_cast<double>(random() % 6)});
    }
    const std::vector<bool> front = pareto_front(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
      bool beaten = false;
      for (std::size_t j = 0; j < points.size(); ++j) {
        beaten = beaten ||
                 (front[j] && points[j].gain >= points[i].gain &&
                  points[j].retention >= points[i].retention &&
                  (points[j].gain != points[i].gain || points[j].retention != points[i].retention));
      }
      ASSERT_EQ(front[i], !beaten);
    }
  }
}

}  // namespace
}  // namespace tcert::study
