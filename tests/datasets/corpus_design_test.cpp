#include "datasets/corpus/design.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace tcert {
namespace {

using CellKey = std::pair<Algorithm, Lighting>;

TEST(TableOfCells, AddsUpToThePublishedTotals) {
  std::uint32_t trials = 0;
  std::uint32_t successes = 0;
  for (const Cell& cell : table_of_cells()) {
    trials += cell.trials;
    successes += cell.successes;
  }
  EXPECT_EQ(trials, 660U);
  EXPECT_EQ(successes, 583U);
}

// The rates as Table 1 prints them, per cent: CB-V Dark 86.7, Indoor 86.7, Outdoor 76.7, M1 80.0,
// ...
TEST(TableOfCells, RoundsToEveryPrintedRate) {
  const std::array<double, 18> printed{86.7,
                                       86.7,
                                       76.7,
                                       80.0,
                                       100.0,
                                       86.7,
                                       90.0,
                                       86.7,
                                       83.3,
                                       88.3,
                                       88.3,
                                       86.7,
                                       90.0,
                                       93.3,
                                       93.3,
                                       93.3,
                                       90.0,
                                       93.3};
  for (std::size_t i = 0; i < printed.size(); ++i) {
    const Cell& cell = table_of_cells()[i];
    EXPECT_NEAR(100.0 * cell.successes / cell.trials, printed[i], 0.05)
        << name_of(cell.algorithm) << ' ' << name_of(cell.lighting);
  }
}

TEST(DesignBlock, HoldsTheTableInEveryBlockOfEverySeed) {
  for (const std::uint64_t seed : {1U, 2U, 99U}) {
    for (const std::uint64_t block : {0U, 1U, 1000U}) {
      SCOPED_TRACE(std::to_string(seed) + "/" + std::to_string(block));
      CorpusOptions options;
      options.seed = seed;
      std::map<CellKey, std::pair<std::uint32_t, std::uint32_t>> counts;
      for (const TrialDesign& trial : design_block(options, block)) {
        auto& [trials, successes] = counts[{trial.algorithm, trial.lighting}];
        ++trials;
        successes += trial.success ? 1U : 0U;
      }
      for (const Cell& cell : table_of_cells()) {
        EXPECT_EQ(counts[std::make_pair(cell.algorithm, cell.lighting)],
                  std::make_pair(cell.trials, cell.successes));
      }
    }
  }
}

TEST(DesignBlock, SpreadsTheCellsOver22DaysOf30Trials) {
  const auto trials = design_block({}, 3);
  std::map<std::uint64_t, std::uint32_t> sizes;
  std::map<std::uint64_t, std::map<CellKey, int>> cells;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_EQ(trials[i].index, 3 * kTrialsPerBlock + i);
    ++sizes[trials[i].day];
    ++cells[trials[i].day][{trials[i].algorithm, trials[i].lighting}];
  }
  ASSERT_EQ(sizes.size(), kDaysPerBlock);
  EXPECT_EQ(sizes.begin()->first, 3 * kDaysPerBlock);
  for (const auto& [day, size] : sizes) {
    EXPECT_EQ(size, kTrialsPerDay);
    EXPECT_GE(cells[day].size(), 12U);
    for (const auto& [cell, count] : cells[day]) {
      EXPECT_LE(count, 4);
    }
  }
}

TEST(DesignTrial, DependsOnSeedAndIndexAlone) {
  CorpusOptions small;
  small.trials = 10;
  CorpusOptions large;
  large.trials = 5000;
  large.subset = {7, 661};
  for (const std::uint64_t index : {0U, 7U, 661U}) {
    const TrialDesign a = design_trial(small, index);
    const TrialDesign b = design_trial(large, index);
    EXPECT_EQ(a.algorithm, b.algorithm);
    EXPECT_EQ(a.lighting, b.lighting);
    EXPECT_EQ(a.day, b.day);
    EXPECT_EQ(a.day_level, b.day_level);
    EXPECT_EQ(a.success, b.success);
  }
}

TEST(DesignTrial, IsAnotherStudyForAnotherSeed) {
  CorpusOptions other;
  other.seed = 2;
  const auto a = design_block({}, 0);
  const auto b = design_block(other, 0);
  int same = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    same += a[i].algorithm == b[i].algorithm && a[i].lighting == b[i].lighting ? 1 : 0;
  }
  EXPECT_LT(same, 100);
}

TEST(CorpusOptions, AreRefusedWithTheValueFound) {
  const auto message = [](const CorpusOptions& options) -> std::string {
    try {
      validate(options);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  CorpusOptions options;
  EXPECT_EQ(message(options), "accepted");
  options.effect = -0.5;
  EXPECT_EQ(message(options), "effect: expected a number in [0, 2], found -0.5");
  options = {};
  options.trials = 0;
  EXPECT_EQ(message(options), "trials: expected at least 1, found 0");
  options = {};
  options.subset = {660};
  EXPECT_EQ(message(options),
            "subset: expected indices below 660, the number of trials, found 660");
}

}  // namespace
}  // namespace tcert
