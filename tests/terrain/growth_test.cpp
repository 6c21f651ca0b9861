#include <gtest/gtest.h>

#include <random>
#include <terrain/disc_growth.hpp>
#include <terrain/distance_transform.hpp>

namespace tcert::terrain {
namespace {

CellSet random_set(const Grid& grid, std::mt19937& random, double share) {
  std::bernoulli_distribution member(share);
  CellSet set(grid.size());
  for (auto& cell : set) {
    cell = member(random) ? 1 : 0;
  }
  return set;
}

std::vector<double> random_bounds(const Grid& grid, std::mt19937& random, double low, double high) {
  std::uniform_real_distribution<double> value(low, high);
  std::vector<double> bounds(grid.size());
  for (double& bound : bounds) {
    // Few values, so that distances are met exactly.
    bound = std::round(value(random));
  }
  return bounds;
}

const std::vector<Grid> kGrids{{1, 1}, {1, 17}, {17, 1}, {9, 13}, {31, 22}};

TEST(DistanceTransform, EqualsBruteForce) {
  std::mt19937 random(3);
  for (const Grid& grid : kGrids) {
    for (const double share : {0.0, 0.02, 0.3, 0.9, 1.0}) {
      const CellSet set = random_set(grid, random, share);
      const auto transform = squared_distance_transform(grid, set);
      const auto depth = squared_depth(grid, set);
      for (std::size_t i = 0; i < grid.size(); ++i) {
        std::int64_t to_member = kNoCell;
        std::int64_t to_other = kNoCell;
        for (std::size_t j = 0; j < grid.size(); ++j) {
          const auto d2 = static_cast<std::int64_t>(squared_distance(grid.cell(i), grid.cell(j)));
          auto& nearest = set[j] != 0 ? to_member : to_other;
          nearest = std::min(nearest, d2);
        }
        ASSERT_EQ(to_member, transform[i]);
        ASSERT_EQ(to_other, depth[i]);
      }
    }
  }
}

TEST(DiscGrowth, EqualsBruteForce) {
  std::mt19937 random(5);
  for (int run = 0; run < 200; ++run) {
    const Grid grid = kGrids[static_cast<std::size_t>(run) % kGrids.size()];
    // Blobs, so that some discs lie within the set.
    CellSet safe = random_set(grid, random, 0.01);
    const auto seeds = squared_distance_transform(grid, safe);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      safe[i] = seeds[i] <= 16 ? 1 : 0;
    }
    std::vector<double> lower = random_bounds(grid, random, run % 2 == 0 ? 10.0 : 0.0, 30.0);
    if (run % 7 == 0) {
      lower[0] = INFINITY;
      lower[grid.size() - 1] = -INFINITY;
    }
    constexpr double kThreshold = 10.0;
    const double lipschitz = run % 3 == 0 ? 0.01 : 3.0;
    const CellSet grown =
        grow_discs(grid, safe, lower, kThreshold, lipschitz, squared_depth(grid, safe));
    for (std::size_t i = 0; i < grid.size(); ++i) {
      bool expected = false;
      for (std::size_t j = 0; j < grid.size(); ++j) {
        expected =
            expected ||
            (safe[j] != 0 &&
             reaches(
                 lower[j], kThreshold, lipschitz, squared_distance(grid.cell(i), grid.cell(j))));
      }
      ASSERT_EQ(expected ? 1 : 0, grown[i]) << "run " << run << " cell " << i;
    }
  }
}

TEST(Expanders, EqualBruteForce) {
  std::mt19937 random(11);
  for (int run = 0; run < 200; ++run) {
    const Grid grid = kGrids[static_cast<std::size_t>(run) % kGrids.size()];
    const CellSet safe = random_set(grid, random, run % 5 == 0 ? 1.0 : 0.8);
    const std::vector<double> upper = random_bounds(grid, random, 5.0, 20.0);
    const CellSet found = expanders(safe, upper, 10.0, 3.0, squared_depth(grid, safe));
    for (std::size_t i = 0; i < grid.size(); ++i) {
      bool expected = false;
      for (std::size_t j = 0; j < grid.size(); ++j) {
        expected = expected ||
                   (safe[i] != 0 && safe[j] == 0 &&
                    reaches(upper[i], 10.0, 3.0, squared_distance(grid.cell(i), grid.cell(j))));
      }
      ASSERT_EQ(expected ? 1 : 0, found[i]);
    }
  }
}

}  // namespace
}  // namespace tcert::terrain
