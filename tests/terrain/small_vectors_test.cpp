#include <gtest/gtest.h>

#include <terrain/planner.hpp>

#include "terrain/vectors.hpp"

namespace tcert::terrain {
namespace {

constexpr Grid kGrid{20, 15};
constexpr Cell kGoal{17, 12};

struct Vector {
  const char* name;
  Rules rules;
  GpPrior prior;
  std::vector<Cell> seeds;
  std::vector<Cell> batch;
};

std::vector<Cell> seed_cells() {
  std::vector<Cell> cells;
  for (int i = 2; i <= 4; ++i) {
    for (int j = 1; j <= 3; ++j) {
      cells.push_back({i, j});
    }
  }
  return cells;
}

Vector thesis_vector(bool everywhere) {
  Vector v;
  v.name = everywhere ? "V2" : "V1";
  v.rules.kind = RuleSet::thesis;
  v.rules.threshold = 0.5;
  v.rules.lipschitz = 0.46;
  v.rules.beta = 4.0;
  v.rules.expanders = 6;
  v.rules.model_everywhere = everywhere;
  v.prior = {1.0, 0.5, 3.0, 1e-4};
  v.seeds = seed_cells();
  if (everywhere) {
    v.batch = {{3, 2}, {2, 1}, {4, 3}};
  }
  return v;
}

Vector published_vector() {
  Vector v;
  v.name = "V3";
  v.rules.kind = RuleSet::published;
  v.rules.threshold = 0.5;
  v.rules.lipschitz = 0.05;
  v.rules.beta = 1.0;
  v.rules.expanders = 6;
  v.prior = {0.0, 0.5, 3.2, 1e-2};
  v.batch = seed_cells();  // all nine are measured first
  return v;
}

void expect_number(double expected, double found, const std::string& what) {
  if (std::isinf(expected)) {
    EXPECT_EQ(expected, found) << what;
  } else {
    EXPECT_NEAR(expected, found, 1e-9) << what;
  }
}

/// Every cell of every step: t,i,j,f,l,u,inS,inG.
void expect_cells(const Planner& planner,
                  const table::TextTable& table,
                  std::size_t step,
                  bool expander_column) {
  for (std::size_t k = 0; k < kGrid.size(); ++k) {
    const std::size_t row = step * kGrid.size() + k;
    const auto value = [&](std::size_t column) { return std::stod(table.at(row, column)); };
    const std::string what = "step " + table.at(row, 0) + " cell " + std::to_string(k);
    ASSERT_NEAR(value(3), test::small_field(kGrid.cell(k)), 1e-10) << what;
    expect_number(value(4), planner.intervals().lower[k], what);
    expect_number(value(5), planner.intervals().upper[k], what);
    EXPECT_EQ(value(6), planner.safe()[k]) << what;
    if (expander_column) {
      EXPECT_EQ(value(7), planner.expander_set()[k]) << what;
    }
  }
}

void expect_vector(const Vector& v) {
  TCERT_NEED_VECTOR("testvec.json");
  const nlohmann::json steps = test::read_vector("testvec.json").at(v.name);
  const auto cells =
      table::read_text_table(test::vectors() / (std::string("testvec_") + v.name + ".csv.gz"));
  ASSERT_TRUE(cells.table);
  Planner planner(kGrid, v.rules, v.prior, v.seeds);
  for (const Cell c : v.batch) {
    planner.add({position(c), test::small_field(c)});
  }
  ASSERT_EQ(10U, steps.size());
  for (std::size_t t = 0; t < steps.size(); ++t) {
    SCOPED_TRACE(std::string(v.name) + " step " + std::to_string(t + 1));
    const nlohmann::json& expected = steps[t];
    const Plan& plan = planner.plan(kGoal);
    EXPECT_EQ(expected.at("S").get<std::size_t>(), plan.safe);
    if (v.rules.kind == RuleSet::published) {
      EXPECT_EQ(expected.at("M").get<std::size_t>(), plan.maximisers);
      EXPECT_EQ(expected.at("cand").get<std::size_t>(), plan.candidates);
      EXPECT_EQ(expected.at("G_all").get<std::size_t>(), plan.expanders);
    } else {
      EXPECT_EQ(expected.at("G").get<std::size_t>(), plan.expanders);
    }
    ASSERT_TRUE(plan.next);
    EXPECT_EQ(expected.at("x")[0].get<int>(), plan.next->x);
    EXPECT_EQ(expected.at("x")[1].get<int>(), plan.next->y);
    expect_number(test::number(expected.at("l")), plan.lower, "l");
    expect_number(test::number(expected.at("u")), plan.upper, "u");
    expect_cells(planner, *cells.table, t, v.rules.kind != RuleSet::published);
    planner.add({position(*plan.next), test::small_field(*plan.next)});
  }
}

TEST(SmallVectors, AlgorithmOneAsPrinted) { expect_vector(thesis_vector(false)); }
TEST(SmallVectors, AlgorithmOneWithTheModelEverywhere) { expect_vector(thesis_vector(true)); }
TEST(SmallVectors, ThePublishedProgram) { expect_vector(published_vector()); }

}  // namespace
}  // namespace tcert::terrain
