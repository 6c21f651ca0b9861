#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <tcert/polar_histogram.hpp>

#include "lib/policies/felt_run.hpp"

namespace tcert::policies {
namespace {

constexpr double kPi = std::numbers::pi;

Densities all(double density) {
  Densities densities{};
  densities.fill(density);
  return densities;
}

void close(Densities& densities, int from, int to) {
  for (int k = from; k <= to; ++k) {
    densities[sector_index(k)] = 1.0;
  }
}

// A grid that holds one cell of certainty 15, at `p`: five contacts of the body.
CertaintyGrid grid_with_cell(Point p) {
  CertaintyGrid grid(two_lobes());
  Outlook far;
  far.body.origin = {-1.8, -1.3};
  far.bump = p;
  for (int i = 0; i < 6; ++i) {
    grid.take(far);
  }
  return grid;
}

TEST(PolarHistogram, SectorsAreCentredOnMultiplesOfFiveDegrees) {
  EXPECT_EQ(sector_of(0.0), 0);
  EXPECT_EQ(sector_of(2.4 * kPi / 180.0), 0);
  EXPECT_EQ(sector_of(2.6 * kPi / 180.0), 1);
  EXPECT_EQ(sector_of(-2.6 * kPi / 180.0), -1);
  EXPECT_EQ(sector_of(2.0 * kPi + 0.1), 1);
  EXPECT_EQ(sector_index(sector_of(kPi)), 36U);
  EXPECT_EQ(sector_index(sector_of(-kPi)), 36U);
  EXPECT_EQ(sector_index(-1), 71U);
  EXPECT_NEAR(angle_of(-1.5), -7.5 * kPi / 180.0, 1e-15);
}

// Right value 4: m = 15^2 (2 - 1 * 1) = 225; 6/11 of it in its own sector, 1/11 in the fifth
// beside.
TEST(PolarHistogram, OneCertainCellAtOneMetre) {
  const CertaintyGrid grid = grid_with_cell({1.0, 0.0});
  const Densities density = polar_density(grid, {0.0, 0.0}, 2.0, 1.0);
  EXPECT_EQ(cell_magnitude(15.0, 1.0, 2.0, 1.0), 225.0);
  EXPECT_EQ(density[0], 225.0);
  const Densities smooth = smoothed(density);
  EXPECT_NEAR(smooth[0], 1350.0 / 11.0, 1e-12);
  EXPECT_NEAR(smooth[0], 122.727, 5e-4);
  for (const int side : {-1, 1}) {
    EXPECT_NEAR(smooth[sector_index(5 * side)], 225.0 / 11.0, 1e-12);
    EXPECT_NEAR(smooth[sector_index(5 * side)], 20.4545, 5e-5);
    EXPECT_EQ(smooth[sector_index(6 * side)], 0.0);
  }
}

TEST(PolarHistogram, CellsCountByCertaintyAndNearness) {
  EXPECT_EQ(cell_magnitude(3.0, 0.5, 2.0, 1.0), 13.5);
  EXPECT_EQ(cell_magnitude(3.0, 2.0, 2.0, 1.0), 0.0);
  EXPECT_EQ(cell_magnitude(3.0, 2.5, 2.0, 1.0), 0.0);
  EXPECT_EQ(cell_magnitude(0.0, 0.5, 2.0, 1.0), 0.0);
}

TEST(PolarHistogram, SmoothingKeepsWhatIsEvenAndWrapsRound) {
  const Densities even = smoothed(all(11.0));
  EXPECT_NEAR(even[0], 36.0, 1e-12);
  EXPECT_NEAR(even[71], 36.0, 1e-12);
  Densities one{};
  one[70] = 11.0;
  EXPECT_NEAR(smoothed(one)[1], 3.0, 1e-12);  // three sectors off
}

TEST(ChooseValley, GoesForATargetThatIsFree) {
  EXPECT_EQ(choose_valley(all(0.0), 0.5, 7, 1), 0.0);
  EXPECT_EQ(choose_valley(all(1.0), 0.5, 7, 1), std::nullopt);
  Densities density = all(0.0);
  close(density, 20, 30);
  EXPECT_EQ(choose_valley(density, 0.5, 0, 1), 0.0);
}

TEST(ChooseValley, KeepsHalfAWidestValleyOffTheBorder) {
  Densities density = all(0.0);
  close(density, -20, -4);  // target 0 lies 3 sectors inside of a valley that begins at -3
  EXPECT_EQ(choose_valley(density, 0.5, 0, 1), 6.0);
  close(density, -20, 2);  // the target itself is closed; the valley to the left begins at 3
  EXPECT_EQ(choose_valley(density, 0.5, 0, 1), 12.0);
}

TEST(ChooseValley, PassesANarrowOneInItsMiddle) {
  Densities density = all(1.0);
  for (int k = 3; k <= 8; ++k) {
    density[sector_index(k)] = 0.0;
  }
  EXPECT_EQ(choose_valley(density, 0.5, 0, 1), 5.5);
  EXPECT_EQ(choose_valley(density, 0.5, 4, -1), 1.5);
  EXPECT_EQ(choose_valley(density, 0.5, 70, 1), 7.5) << "valleys wrap";
}

TEST(ChooseValley, OfTwoAsNearTakesThatOnTheSide) {
  Densities density = all(0.0);
  close(density, -4, 4);
  density[sector_index(20)] = density[sector_index(-20)] = 1.0;
  EXPECT_EQ(choose_valley(density, 0.5, 0, 1), 12.0);
  EXPECT_EQ(choose_valley(density, 0.5, 0, -1), -12.0);
}

TEST(ChooseValley, IsMirroredWithTheDensities) {
  std::mt19937 engine(3);
  for (std::uint32_t run = 0; run < 10'000; ++run) {
    Densities density{};
    Densities image{};
    for (int k = 0; k < kSectors; ++k) {
      const double value = (engine() % 8) < run % 8 ? 1.0 : 0.0;
      density[sector_index(k)] = value;
      image[sector_index(-k)] = value;
    }
    const int target = static_cast<int>(engine() % kSectors);
    const int side = engine() % 2 == 0 ? 1 : -1;
    const auto one = choose_valley(density, 0.5, target, side);
    const auto other = choose_valley(image, 0.5, -target, -side);
    ASSERT_EQ(one.has_value(), other.has_value());
    ASSERT_EQ(one.value_or(0.0), -other.value_or(0.0)) << "run " << run;
    ASSERT_EQ(least_dense(density, target, side), -least_dense(image, -target, -side));
    if (one) {
      const int whole = static_cast<int>(std::floor(target + *one));
      ASSERT_LT(density[sector_index(whole)], 0.5) << "it leads into a valley";
    }
  }
}

}  // namespace
}  // namespace tcert::policies
