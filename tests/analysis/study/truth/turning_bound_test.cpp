#include "analysis/study/truth/turning_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "analysis/study/soundness/soundness.hpp"
#include "analysis/study/truth/curvature_value.hpp"
#include "analysis/study/truth/truth.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/random_world.hpp"

namespace tcert::study {
namespace {

constexpr double kCell = 0.01;

// T of a U-turn is known exactly.
TEST(TurningBound, IsAtLeastTheTruthOfUTurnsAndLittleAbove) {
  std::vector<double> above_m;
  std::size_t lower_than_clearance = 0;
  for (std::uint64_t index = 0; index < 24; ++index) {
    const RandomWorld drawn = draw_random_world(WorldFamily::u_turn, 5, index);
    const double truth_m = u_turn_value(drawn.corridor_m, drawn.wall_m, corpus_robot());
    const double by_clearance_m = upper_value(drawn, corpus_robot());
    const double bound_m = turning_upper(
        drawn.world, corpus_robot(), SlackConvention::width, -1.0, by_clearance_m, kCell);
    EXPECT_GE(bound_m, truth_m) << index;
    EXPECT_LE(bound_m, by_clearance_m) << index;
    above_m.push_back(bound_m - truth_m);
    lower_than_clearance += bound_m < by_clearance_m - 0.01 ? 1U : 0U;
  }
  std::ranges::sort(above_m);
  std::cout << above_m.size() << " U-turns: above the truth by " << above_m[above_m.size() / 2]
            << " m at the median, " << above_m.back() << " at most; below clearance in "
            << lower_than_clearance << "\n";
  EXPECT_LT(above_m[above_m.size() / 2], 0.10);  // measured: 0.092; 0.068 in cells of 5 mm
  EXPECT_GT(lower_than_clearance, 8U);
}

// No path that another search finds and measures exceeds it.
TEST(TurningBound, IsAboveWhateverIsFound) {
  std::size_t found = 0;
  for (std::uint64_t index = 0; index < 12; ++index) {
    const RandomWorld drawn = draw_random_world(mixed_family(index), 6, index);
    Robot robot = corpus_robot();
    robot.min_turn_radius_m = index % 3 == 0 ? 0.35 : index % 3 == 1 ? 0.6 : 1.0;
    const double by_clearance_m = upper_value(drawn, robot);
    const CurvatureValue lower = curvature_value(drawn.world, robot, by_clearance_m);
    const double bound_m = turning_upper(
        drawn.world, robot, SlackConvention::width, lower.slack_m, by_clearance_m, 0.02);
    EXPECT_GE(bound_m, lower.slack_m) << index;
    found += std::isfinite(lower.slack_m) ? 1U : 0U;
  }
  EXPECT_GT(found, 6U);
}

World corridor() {
  World world;
  world.name = "corridor";
  world.bounds = {{0.0, 0.0}, {4.0, 1.0}};
  world.start = Disc{{0.6, 0.5}, 0.1};
  world.goal = Disc{{3.4, 0.5}, 0.1};
  return world;
}

TEST(TurningBound, OfAStraightCorridorIsThatOfItsWidth) {
  EXPECT_EQ(turning_upper(corridor(), corpus_robot(), SlackConvention::width, 0.3, 0.55, kCell),
            0.55);
}

TEST(TurningBound, RefusesWorldsWithoutEndsAndCellsWithoutNumber) {
  World world = corridor();
  EXPECT_THROW((void)turning_upper(world, corpus_robot(), SlackConvention::width, 0.3, 0.55, 1e-6),
               std::invalid_argument);
  world.goal.reset();
  EXPECT_THROW((void)turning_upper(world, corpus_robot(), SlackConvention::width, 0.3, 0.55, kCell),
               std::invalid_argument);
}

TEST(TurningBound, LowersWhatIsSaidOfAWorldIfItIsAsked) {
  const RandomWorld drawn = draw_random_world(WorldFamily::u_turn, 5, 1);
  const Truth as_it_was = truth_of(drawn.world, corpus_robot());
  TruthOptions options;
  options.turn_cell_m = kCell;
  const Truth bounded = truth_of(drawn.world, corpus_robot(), options);
  EXPECT_EQ(bounded.lower_m, as_it_was.lower_m);
  EXPECT_LE(bounded.upper_m, as_it_was.upper_m);
  EXPECT_GE(bounded.upper_m, bounded.lower_m);
}

}  // namespace
}  // namespace tcert::study
