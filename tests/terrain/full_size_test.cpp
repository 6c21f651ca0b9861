#include <gtest/gtest.h>

#include <cmath>
#include <terrain/planner.hpp>

#include "datasets/terrain_file.hpp"
#include "terrain/vectors.hpp"

namespace tcert::terrain {
namespace {

TEST(FullSize, TenStepsOfThePublishedProgram) {
  TCERT_NEED_VECTOR("testvec_terrain.json");
  TCERT_NEED_VECTOR("terrain_600x400.csv.gz");
  // The published program drops the first row.
  const auto file =
      read_terrain(test::vectors() / "terrain_600x400.csv.gz", {{}, TerrainHeader::yes});
  ASSERT_TRUE(file.terrain);
  const Grid grid{file.terrain->rows, file.terrain->columns};
  const std::vector<double>& terrain = file.terrain->values;
  ASSERT_EQ((Grid{599, 400}), grid);
  Rules rules;
  rules.kind = RuleSet::published;
  Planner planner(grid, rules, {0.0, 2.0, 30.0, 1.0 + 1e-8});
  const auto measure = [&](Cell c) {
    // The vector was made from values with one decimal. The file's two do not tell which way a 5
    // goes: 1451.65 was below, the other three that were measured were above.
    const double tenths = terrain[grid.index(c)] * 10.0;
    const bool down = c == Cell{246, 212};
    planner.add({position(c), (down ? std::floor(tenths) : std::round(tenths)) / 10.0});
  };
  for (const int a : {-16, -8, 0, 8, 16}) {
    for (const int b : {-16, -8, 0, 8, 16}) {
      measure({230 + a, 220 + b});
    }
  }
  const nlohmann::json steps = test::read_vector("testvec_terrain.json");
  ASSERT_EQ(10U, steps.size());
  for (const nlohmann::json& expected : steps) {
    SCOPED_TRACE(expected.at("t").dump());
    const Plan& plan = planner.plan(Cell{104, 82});
    EXPECT_EQ(expected.at("S").get<std::size_t>(), plan.safe);
    EXPECT_EQ(expected.at("M").get<std::size_t>(), plan.maximisers);
    EXPECT_EQ(expected.at("cand").get<std::size_t>(), plan.candidates);
    EXPECT_EQ(expected.at("G_all").get<std::size_t>(), plan.expanders);
    ASSERT_TRUE(plan.next);
    EXPECT_EQ(expected.at("x")[0].get<int>(), plan.next->x);
    EXPECT_EQ(expected.at("x")[1].get<int>(), plan.next->y);
    EXPECT_NEAR(expected.at("l").get<double>(), plan.lower, 1e-8);
    EXPECT_NEAR(expected.at("u").get<double>(), plan.upper, 1e-8);
    const std::size_t i = grid.index(*plan.next);
    EXPECT_NEAR(expected.at("mean").get<double>(), planner.model().mean()[i], 1e-8);
    measure(*plan.next);
  }
}

}  // namespace
}  // namespace tcert::terrain
