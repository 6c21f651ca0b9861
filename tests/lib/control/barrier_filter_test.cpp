#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tcert/barrier_filter.hpp>
#include <vector>

#include "support/allocations.hpp"

namespace tcert {
namespace {

// R's quadprog gives these.
TEST(NearestCommand, HasTheOptimumOfAQuadraticProgram) {
  struct Case {
    Command wanted;
    std::vector<BarrierRow> rows;
    Command best;
  };
  for (const Case& c :
       {Case{{0.22, 0.0}, {{-1.0, 0.0, -0.10}}, {0.1, 0.0}},
        Case{{0.22, 0.0}, {{-1.0, 0.3, -0.16}}, {0.184059405940594, 0.080198019801980}},
        Case{{0.22, 0.2},
             {{-1.0, 0.3, -0.10}, {-0.5, -0.2, -0.09}},
             {0.134285714285714, 0.114285714285714}},
        Case{{0.22, 0.2},
             {{-1.0, 0.3, 0.01}, {-0.5, -0.2, -0.02}},
             {0.0114285714285714, 0.0714285714285715}}}) {
    const FilteredCommand found = nearest_command(c.wanted, c.rows, {});
    EXPECT_TRUE(found.feasible);
    EXPECT_NEAR(found.command.speed_mps, c.best.speed_mps, 1e-14);
    EXPECT_NEAR(found.command.yaw_rate_rps, c.best.yaw_rate_rps, 1e-14);
  }
  const std::vector<BarrierRow> impossible{{-1.0, 0.0, 0.05}};
  const FilteredCommand none = nearest_command({0.22, 0.0}, impossible, {});
  EXPECT_FALSE(none.feasible);
  EXPECT_EQ(none.command.speed_mps, 0.0);
}

double cost_of(const Command& u, const Command& wanted) {
  const double v = (u.speed_mps - wanted.speed_mps) / 0.22;
  const double w = (u.yaw_rate_rps - wanted.yaw_rate_rps) / 0.6;
  return v * v + w * w;
}

double worst_slack(const Command& u, const std::vector<BarrierRow>& rows) {
  double worst = 1.0;
  for (const BarrierRow& row : rows) {
    worst = std::min(worst, row.speed * u.speed_mps + row.yaw_rate * u.yaw_rate_rps - row.least);
  }
  return worst;
}

// A grid of all commands knows no better, and what is returned keeps every row.
TEST(NearestCommand, IsNoWorseThanAnyOfAGrid) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::uniform_int_distribution<std::size_t> count(0, kMostBarrierRows);
  int infeasible = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<BarrierRow> rows(count(random));
    for (BarrierRow& row : rows) {
      row = {unit(random), 0.3 * unit(random), 0.1 * unit(random) - 0.05};
    }
    const Command wanted{0.11 + 0.2 * unit(random), 0.8 * unit(random)};
    const FilteredCommand found = nearest_command(wanted, rows, {});
    infeasible += found.feasible ? 0 : 1;
    const double best = found.feasible ? cost_of(found.command, wanted) : 1e9;
    if (found.feasible) {
      ASSERT_GE(worst_slack(found.command, rows), -1e-12);
      ASSERT_GE(found.command.speed_mps, 0.0);
      ASSERT_LE(found.command.speed_mps, 0.22);
      ASSERT_LE(std::abs(found.command.yaw_rate_rps), 0.6);
    }
    for (int a = 0; a <= 100; ++a) {
      for (int b = -100; b <= 100; ++b) {
        const Command u{0.0022 * a, 0.006 * b};
        if (worst_slack(u, rows) >= 1e-9) {
          ASSERT_TRUE(found.feasible) << i;
          ASSERT_LE(best, cost_of(u, wanted) + 1e-12) << i;
        }
      }
    }
  }
  EXPECT_GT(infeasible, 5);
  EXPECT_LT(infeasible, 200);
}

TEST(NearestCommand, LeavesWhatKeepsAllRowsToTheBit) {
  const std::vector<BarrierRow> rows{{-1.0, 0.3, -0.3}};
  const Command wanted{0.1234567, -0.345};
  EXPECT_EQ(nearest_command(wanted, rows, {}).command.speed_mps, wanted.speed_mps);
  EXPECT_EQ(nearest_command(wanted, rows, {}).command.yaw_rate_rps, wanted.yaw_rate_rps);
}

TEST(NearestCommand, AllocatesNothing) {
  const std::vector<BarrierRow> rows(kMostBarrierRows, {-1.0, 0.3, -0.1});
  const std::size_t before = test_support::allocation_count();
  EXPECT_TRUE(nearest_command({0.22, 0.6}, rows, {}).feasible);
  EXPECT_EQ(test_support::allocation_count(), before);
}

}  // namespace
}  // namespace tcert
