#include "datasets/import/sample_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tcert::recording {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

struct Passed {
  std::vector<std::int64_t> times;
  std::vector<double> values;
  StreamUse use;
};

Passed pass(const std::vector<std::pair<std::int64_t, double>>& rows) {
  Passed passed;
  SampleOrder order(kSecond, [&](const Sample& sample) {
    passed.times.push_back(sample.time_ns);
    passed.values.push_back(sample.values[0]);
  });
  std::size_t place = 0;
  for (const auto& [time_ns, value] : rows) {
    order.add(time_ns, std::vector<double>{value}, ++place);
  }
  passed.use = order.finish();
  return passed;
}

TEST(SampleOrder, MovesWhatIsALittleLate) {
  const Passed passed = pass({{0, 0}, {2, 2}, {1, 1}, {3, 3}});
  EXPECT_EQ(passed.values, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(passed.use.moved, 1U);
  EXPECT_EQ(passed.use.used, 4U);
}

TEST(SampleOrder, DoesNotInterleaveWhatCameOfAClockThatWasSetBack) {
  const Passed passed = pass({{8 * kSecond, 0},
                              {9 * kSecond, 1},
                              {10 * kSecond, 2},
                              {5 * kSecond, 3},
                              {6 * kSecond, 4},
                              {11 * kSecond, 5}});
  EXPECT_EQ(passed.values, (std::vector<double>{0, 1, 2, 5}));
  EXPECT_EQ(passed.use.set_back, 2U);
  EXPECT_EQ(passed.use.first_set_back, 4U);
  EXPECT_EQ(passed.use.set_back_by_ns, 5 * kSecond);
}

TEST(SampleOrder, UsesTheFirstOfOneTime) {
  const Passed passed = pass({{0, 1}, {0, 2}, {kSecond, 3}, {kSecond, 4}});
  EXPECT_EQ(passed.values, (std::vector<double>{1, 3}));
  EXPECT_EQ(passed.use.same_time, 2U);
}

TEST(SampleOrder, TakesTimesBeforeZero) {
  EXPECT_EQ(pass({{-5, 1}, {-3, 2}}).times, (std::vector<std::int64_t>{-5, -3}));
}

// Against a stable sort: whatever is late by less than the window ends in its place.
TEST(SampleOrder, IsAStableSortWithinTheWindow) {
  std::mt19937_64 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::pair<std::int64_t, double>> rows;
    for (int i = 0; i < 300; ++i) {
      const auto jitter = static_cast<std::int64_t>(random() % 9) * kSecond / 10;
      rows.emplace_back(i * kSecond / 10 + jitter, i);
    }
    const Passed passed = pass(rows);
    std::ranges::stable_sort(rows, {}, [](const auto& row) { return row.first; });
    std::vector<double> expected;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i == 0 || rows[i].first != rows[i - 1].first) {
        expected.push_back(rows[i].second);
      }
    }
    ASSERT_EQ(passed.values, expected);
    EXPECT_EQ(passed.use.used + passed.use.same_time, rows.size());
  }
}

}  // namespace
}  // namespace tcert::recording
