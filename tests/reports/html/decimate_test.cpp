#include "reports/html/decimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <vector>

namespace tcert {
namespace {

using Columns = std::vector<std::vector<double>>;

std::vector<std::span<const double>> views(const Columns& columns) {
  return {columns.begin(), columns.end()};
}

Columns random_columns(std::mt19937& engine, std::size_t count, std::size_t rows) {
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  Columns columns(count, std::vector<double>(rows));
  for (auto& column : columns) {
    double sum = 0.0;
    for (double& one : column) {
      sum += value(engine);
      one = value(engine) > 0.9 ? std::numeric_limits<double>::quiet_NaN() : sum;
    }
  }
  return columns;
}

/// Smallest and largest of the values that are there.
std::pair<double, double> range(const std::vector<double>& values) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isnan(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return {low, high};
}

TEST(KeptTicks, AllIfThereAreFewEnough) {
  const Columns columns = {{1, 2, 3}};
  EXPECT_EQ(kept_ticks(3, views(columns), {}, 3), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(kept_ticks(0, {}, {}, 3).empty());
}

TEST(KeptTicks, ASpikeOfOneTickStays) {
  Columns columns = {std::vector<double>(1000, 0.0)};
  columns[0][617] = 5.0;
  columns[0][618] = -5.0;
  const auto kept = kept_ticks(1000, views(columns), {}, 20);
  EXPECT_LE(kept.size(), 20U);
  EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 617U));
  EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), 618U));
}

TEST(KeptTicks, KeepsEveryRangeTheEndsAndWhatIsAskedFor) {
  std::mt19937 engine(20261128);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const std::size_t rows = 50 + engine() % 900;
    const std::size_t limit = 20 + engine() % 200;
    const Columns columns = random_columns(engine, 1 + engine() % 4, rows);
    const std::vector<std::size_t> always = {engine() % rows, engine() % rows};
    const auto kept = kept_ticks(rows, views(columns), always, limit);
    EXPECT_LE(kept.size(), limit);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
    EXPECT_EQ(std::adjacent_find(kept.begin(), kept.end()), kept.end());
    EXPECT_EQ(kept.front(), 0U);
    EXPECT_EQ(kept.back(), rows - 1);
    for (const std::size_t tick : always) {
      EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), tick));
    }
    for (const auto& column : columns) {
      std::vector<double> shown;
      for (const std::size_t tick : kept) {
        shown.push_back(column[tick]);
      }
      EXPECT_EQ(range(shown), range(column));
    }
  }
}

TEST(KeptTicks, AGapOfOneTickStaysAGap) {
  const double missing = std::numeric_limits<double>::quiet_NaN();
  Columns columns(2, std::vector<double>(1000));
  for (std::size_t i = 0; i < 1000; ++i) {
    columns[0][i] = std::sin(static_cast<double>(i) / 50.0);
    columns[1][i] = 1.0;
  }
  columns[0][503] = missing;
  const auto few = kept_ticks(1000, views(columns), {}, 40);
  EXPECT_LE(few.size(), 40U);
  for (const std::size_t tick : {502U, 503U, 504U}) {
    EXPECT_TRUE(std::binary_search(few.begin(), few.end(), tick)) << tick;
  }
  // So many gaps that their ends alone are too many: one of each bucket.
  for (std::size_t i = 0; i < 1000; i += 3) {
    columns[0][i] = missing;
  }
  const auto many = kept_ticks(1000, views(columns), {}, 40);
  EXPECT_LE(many.size(), 40U);
  EXPECT_GT(
      std::count_if(
          many.begin(), many.end(), [&](std::size_t tick) { return std::isnan(columns[0][tick]); }),
      8);
}

TEST(KeptTicks, FillsMostOfTheLimit) {
  std::mt19937 engine(7);
  const Columns columns = random_columns(engine, 6, 5000);
  EXPECT_GT(kept_ticks(5000, views(columns), {}, 400).size(), 350U);
}

}  // namespace
}  // namespace tcert
