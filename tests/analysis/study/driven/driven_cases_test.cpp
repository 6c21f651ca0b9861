#include "analysis/study/driven/driven_cases.hpp"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

namespace tcert::study {
namespace {

constexpr std::array kTiers{Lighting::dark, Lighting::indoor, Lighting::outdoor};

TEST(DrivenCases, NoTwoReplicatesOrLightingsShareAWorld) {
  std::set<std::uint64_t> worlds;
  std::map<std::uint64_t, int> days;
  for (std::uint64_t replicate = 0; replicate < 180; ++replicate) {
    for (const Lighting lighting : kTiers) {
      const std::uint64_t world = world_of(lighting, replicate);
      EXPECT_TRUE(worlds.insert(world).second) << replicate;
      ++days[world / kTrialsPerDay];
    }
  }
  EXPECT_EQ(days.size(), 3 * kDaysPerBlock);  // three blocks of sixty
  for (const auto& [day, count] : days) {
    EXPECT_GE(count, 8) << day;
    EXPECT_LE(count, 9) << day;
  }
}

TEST(DrivenCases, ThePapersDesignHasItsCellsAndItsDays) {
  const auto cases = paper_cases(0, 2 * kTrialsPerBlock);
  std::map<std::pair<std::size_t, Lighting>, std::uint32_t> counts;
  std::set<std::uint64_t> days;
  for (const DrivenCase& one : cases) {
    ++counts[{one.arm, one.lighting}];
    days.insert(one.world / kTrialsPerDay);
  }
  for (const Cell& cell : table_of_cells()) {
    const std::pair key(static_cast<std::size_t>(cell.algorithm), cell.lighting);
    EXPECT_EQ(counts[key], 2 * cell.trials);
  }
  EXPECT_EQ(days.size(), 2 * kDaysPerBlock);
  const auto rest = paper_cases(700, 100);
  for (std::size_t i = 0; i < rest.size(); ++i) {
    EXPECT_EQ(rest[i].world, cases[700 + i].world);
    EXPECT_EQ(rest[i].arm, cases[700 + i].arm);
  }
}

TEST(DrivenCases, PoliciesMeetTheSameWorlds) {
  const auto cases = crossed_cases(4, {Lighting::dark, Lighting::outdoor}, 3, 5);
  ASSERT_EQ(cases.size(), 40U);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(cases[i].arm, i % 4);
    EXPECT_EQ(cases[i].world, cases[i / 4 * 4].world);
    EXPECT_EQ(cases[i].world, world_of(cases[i].lighting, 3 + i / 8));
  }
}

TEST(DrivenCases, ArmsOfThePaperAreCalledAsThere) {
  const auto arms = paper_arms();
  ASSERT_EQ(arms.size(), kAlgorithms);
  for (std::size_t a = 0; a < kAlgorithms; ++a) {
    EXPECT_EQ(arms[a].name, name_of(static_cast<Algorithm>(a)));
  }
}

}  // namespace
}  // namespace tcert::study
