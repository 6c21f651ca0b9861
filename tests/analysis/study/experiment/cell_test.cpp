#include "analysis/study/experiment/cell.hpp"

#include <gtest/gtest.h>

#include <set>

#include "analysis/study/experiment/fingerprint.hpp"
#include "analysis/study/experiment/paper_cells.hpp"

namespace tcert::study {
namespace {

Robot robot() {
  Robot robot;
  robot.rays = {{"left", {0.0, 0.0}, 1.57, 0.3, RayKind::range, {}},
                {"right", {0.0, 0.0}, -1.57, 0.3, RayKind::range, {}}};
  return robot;
}

TEST(GridCells, TakeEveryCombinationTheLastAxisFastest) {
  const std::vector<Cell> cells =
      grid_cells(std::vector<GridAxis>{{"beta_per_m", {"5", "10"}}, {"tick_s", {"0.1", "0.2"}}});
  ASSERT_EQ(cells.size(), 4U);
  EXPECT_EQ(cells[0].name, "beta_per_m=5 tick_s=0.1");
  EXPECT_EQ(cells[1].name, "beta_per_m=5 tick_s=0.2");
  EXPECT_EQ(cells[3].name, "beta_per_m=10 tick_s=0.2");
  EXPECT_EQ(cells[3].overrides.size(), 2U);
}

TEST(GridCells, RefuseAnEmptyAxisAndAKeyThatComesTwice) {
  EXPECT_THROW(static_cast<void>(grid_cells({})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(grid_cells(std::vector<GridAxis>{{"tick_s", {}}})),
               std::invalid_argument);
  EXPECT_THROW(
      static_cast<void>(grid_cells(std::vector<GridAxis>{{"tick_s", {"1"}}, {"tick_s", {"2"}}})),
      std::invalid_argument);
}

TEST(Plan, RefusesImpossibleCellsWithTheReason) {
  const auto reason = [](const Cell& cell) {
    const PlannedCell planned = plan(cell, {}, robot(), {});
    return planned.refused() ? std::get<std::string>(planned.parameters) : std::string();
  };
  EXPECT_NE(reason({"", {{"beta_per_m", "0"}}}).find("beta_per_m"), std::string::npos);
  EXPECT_NE(reason({"", {{"memory_half_life_s", "-1"}}}).find("memory_half_life_s"),
            std::string::npos);
  EXPECT_NE(reason({"", {{"min_speed_mps", "0.3"}}}).find("min_speed_mps"), std::string::npos);
  EXPECT_NE(reason({"", {{"betta_per_m", "5"}}}).find("beta_per_m"), std::string::npos);
  EXPECT_EQ(reason({"", {{"beta_per_m", "20"}}}), "");
}

TEST(Plan, PutsOverridesOverTheBase) {
  ParameterSet base;
  base.early_window.quantile = 0.3;
  const PlannedCell planned = plan({"", {{"tick_s", "0.2"}}}, base, robot(), {});
  EXPECT_EQ(planned.set().resample.tick_s, 0.2);
  EXPECT_EQ(planned.set().early_window.quantile, 0.3);
}

TEST(Fingerprint, ChangesOnlyWithWhatAStepDependsOn) {
  const ParameterSet base;
  ParameterSet speed = base;
  set_parameter(speed, "beta_per_m", "20");
  ParameterSet window = base;
  set_parameter(window, "early_quantile", "0.2");
  ParameterSet memory = base;
  set_parameter(memory, "memory_weight_m", "0");
  ParameterSet tick = base;
  set_parameter(tick, "tick_s", "0.2");
  const auto same = [&](const ParameterSet& other, Stage stage) {
    return fingerprint(base, stage) == fingerprint(other, stage);
  };
  EXPECT_TRUE(same(speed, Stage::certify) && same(speed, Stage::features));
  EXPECT_FALSE(same(speed, Stage::control));
  EXPECT_TRUE(same(window, Stage::certify) && same(window, Stage::control));
  EXPECT_FALSE(same(window, Stage::features));
  EXPECT_TRUE(same(memory, Stage::resample));
  EXPECT_FALSE(same(memory, Stage::certify) || same(memory, Stage::features) ||
               same(memory, Stage::control));
  EXPECT_FALSE(same(tick, Stage::resample) || same(tick, Stage::features));
}

TEST(PaperCells, AreAllPossibleAndAllDifferentFromTheFullMethod) {
  for (const auto& cells : {ablation_cells(), sensitivity_cells()}) {
    std::set<std::string> prints{fingerprint({}, Stage::features)};
    for (const Cell& cell : cells) {
      const PlannedCell planned = plan(cell, {}, robot(), {});
      ASSERT_FALSE(planned.refused()) << std::get<std::string>(planned.parameters);
      EXPECT_TRUE(prints.insert(fingerprint(planned.set(), Stage::features)).second) << cell.name;
    }
  }
  EXPECT_EQ(ablation_cells().size(), 7U);
}

}  // namespace
}  // namespace tcert::study
