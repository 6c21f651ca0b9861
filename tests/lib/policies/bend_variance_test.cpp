#include <gtest/gtest.h>

#include <array>
#include <deque>
#include <random>
#include <tcert/bend_variance.hpp>

namespace tcert::policies {
namespace {

Robot robot() {
  Robot made;
  const Calibration calibration{{0.0, 1.2}, {0.45, 0.0}};
  made.rays = {{"left", {}, 1.57, 0.45, RayKind::bend, calibration},
               {"beam", {}, 0.0, 0.45, RayKind::range, {}}};
  return made;
}

TEST(BendVariance, OfTwoSamplesIsTheSquareOfHalfTheirDifference) {
  BendVariance variance(robot(), 1.0, 0.01);
  EXPECT_TRUE(std::isnan(variance.rad2()[0]));
  variance.add(0.0, std::array<RayReading, 2>{{{0.5, 0.0}, {0.1, 0.0}}});
  EXPECT_TRUE(std::isnan(variance.rad2()[0])) << "one sample has no spread";
  variance.add(0.02, std::array<RayReading, 2>{{{0.25, 0.0}, {0.4, 0.0}}});
  EXPECT_EQ(variance.rad2()[0], 0.015625);
  EXPECT_TRUE(std::isnan(variance.rad2()[1])) << "a beam does not bend";
  variance.add(0.021, std::array<RayReading, 2>{{{1.0, 0.0}, {0.4, 0.0}}});
  EXPECT_EQ(variance.rad2()[0], 0.015625) << "no travel, no sample";
  variance.reset();
  EXPECT_TRUE(std::isnan(variance.rad2()[0]));
}

// Against all samples of the window, summed anew about their mean.
TEST(BendVariance, IsThatOfTheWindow) {
  BendVariance variance(robot(), 0.3, 0.01);
  std::mt19937 engine(4);
  const auto uniform = [&] { return static_cast<double>(engine()) / 4294967296.0; };
  std::deque<std::pair<double, double>> samples;
  double travel_m = 0.0;
  for (int step = 0; step < 20'000; ++step) {
    travel_m += 0.0101 + (step % 500 == 0 ? 0.5 : 0.01 * uniform());
    const double bend_rad = step % 7 == 0 ? kMissing : 1.2 * uniform();
    variance.add(travel_m, std::array<RayReading, 2>{{{bend_rad, 0.0}, {0.4, 0.0}}});
    if (std::isnan(bend_rad)) {
      continue;
    }
    samples.emplace_back(travel_m, bend_rad);
    while (travel_m - samples.front().first > 0.3) {
      samples.pop_front();
    }
    const auto n = static_cast<double>(samples.size());
    double mean = 0.0;
    for (const auto& sample : samples) {
      mean += sample.second / n;
    }
    double expected = 0.0;
    for (const auto& sample : samples) {
      expected += (sample.second - mean) * (sample.second - mean) / n;
    }
    if (samples.size() < 2) {
      ASSERT_TRUE(std::isnan(variance.rad2()[0]));
    } else {
      // A bend is rounded to 2^-18 rad.
      ASSERT_NEAR(variance.rad2()[0], expected, 4e-6) << "step " << step;
    }
  }
}

TEST(BendVariance, HasRoomForTheLongestWindowAtTheLargestBends) {
  BendVariance variance(robot(), 1000.0, 1.0);
  for (int step = 0; step < 5'000; ++step) {
    const double bend_rad = step % 2 == 0 ? 1e300 : -1e300;  // counts as 8 rad
    variance.add(step, std::array<RayReading, 2>{{{bend_rad, 0.0}, {0.4, 0.0}}});
    if (step > 2) {
      ASSERT_NEAR(variance.rad2()[0], 64.0, 8.0) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace tcert::policies
