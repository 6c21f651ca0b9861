#include "analysis/model/model_frame.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/data_table.hpp"

namespace tcert {
namespace {

using test_support::table_of;
using Names = std::vector<std::string>;

constexpr const char* kTrials =
    "id,light,x,z,y,time,status,w\n"
    "a,dim,1,0.5,1,3,1,2\n"
    "b,dark,2,1.5,0,4,0,1\n"
    "a,bright,3,NA,1,5,1,1\n"
    "b,dim,4,2.5,0,6,1,1\n"
    "a,dark,5,-1,1,7,0,3\n";

ModelFrame frame(const std::string& formula, const FrameOptions& options = {}) {
  return model_frame(parse_formula(formula), table_of(kTrials), options);
}

std::string problem_of(const std::string& formula, const FrameOptions& options = {}) {
  try {
    static_cast<void>(frame(formula, options));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(ModelFrame, NamesColumnsAsRDoes) {
  EXPECT_EQ(frame("y ~ x + light").columns, (Names{"(Intercept)", "x", "lightdark", "lightdim"}));
  EXPECT_EQ(frame("y ~ x*light").columns,
            (Names{"(Intercept)", "x", "lightdark", "lightdim", "x:lightdark", "x:lightdim"}));
  EXPECT_EQ(frame("y ~ factor(x):id").columns.size(), 11U);
  EXPECT_EQ(frame("y ~ I(x > 2) + factor(id)").columns,
            (Names{"(Intercept)", "I(x > 2)TRUE", "factor(id)b"}));
  // Without the main effect, or without an intercept, a factor has all its levels.
  EXPECT_EQ(frame("y ~ x:light").columns,
            (Names{"(Intercept)", "x:lightbright", "x:lightdark", "x:lightdim"}));
  EXPECT_EQ(frame("y ~ light + id - 1").columns,
            (Names{"lightbright", "lightdark", "lightdim", "idb"}));
  // The first factor of an interaction varies fastest.
  EXPECT_EQ(
      frame("y ~ id*light").columns,
      (Names{"(Intercept)", "idb", "lightdark", "lightdim", "idb:lightdark", "idb:lightdim"}));
}

TEST(ModelFrame, FillsTheColumns) {
  const ModelFrame made = frame("y ~ x*light");
  const Eigen::VectorXd dark = (Eigen::VectorXd(5) << 0, 1, 0, 0, 1).finished();
  const Eigen::VectorXd x = (Eigen::VectorXd(5) << 1, 2, 3, 4, 5).finished();
  EXPECT_EQ(made.design.col(0), Eigen::VectorXd::Ones(5));
  EXPECT_EQ(made.design.col(1), x);
  EXPECT_EQ(made.design.col(2), dark);
  EXPECT_EQ(made.design.col(4), x.cwiseProduct(dark));
  EXPECT_EQ(made.term_of, (std::vector<std::size_t>{0, 1, 2, 2, 3, 3}));
  EXPECT_EQ(made.terms, (Names{"x", "light", "x:light"}));
}

TEST(ModelFrame, AReferenceLevelComesFirst) {
  FrameOptions options;
  options.reference["light"] = "dim";
  EXPECT_EQ(frame("y ~ light", options).columns,
            (Names{"(Intercept)", "lightbright", "lightdark"}));
  options.reference["light"] = "dusk";
  EXPECT_EQ(problem_of("y ~ light", options),
            "column 'light' has no level 'dusk', only bright, dark, dim");
}

TEST(ModelFrame, LeavesOutRowsWithAMissingValueAndTheirLevels) {
  const ModelFrame made = frame("y ~ z + light");
  EXPECT_EQ(made.rows, (std::vector<std::size_t>{0, 1, 3, 4}));
  EXPECT_EQ(made.dropped, 1U);
  // 'bright' only occurred in the row that is left out.
  EXPECT_EQ(made.columns, (Names{"(Intercept)", "z", "lightdim"}));
  ASSERT_EQ(made.conditions.size(), 1U);
  EXPECT_EQ(to_string(made.conditions[0]),
            "note: column 'z': rows with a missing value are left out: 1 of 5 (z in 1)");
}

TEST(ModelFrame, EvaluatesArithmetic) {
  const ModelFrame made = frame("y ~ I(x^2 - 1) + log(x) + scale(x) + I(-x)");
  EXPECT_EQ(made.design(1, 1), 3.0);
  EXPECT_DOUBLE_EQ(made.design(2, 2), std::log(3.0));
  EXPECT_DOUBLE_EQ(made.design(4, 3), 2.0 / std::sqrt(2.5));
  EXPECT_EQ(made.design(0, 4), -1.0);
}

TEST(ModelFrame, TakesSurvivalStrataClusterOffsetWeights) {
  FrameOptions options;
  options.weights = "w";
  const ModelFrame made =
      frame("Surv(time, status) ~ x + strata(light) + cluster(id) + offset(x)", options);
  const auto& outcome = std::get<SurvivalOutcome>(made.outcome);
  EXPECT_EQ(outcome.stop, (std::vector<double>{3, 4, 5, 6, 7}));
  EXPECT_EQ(outcome.event, (std::vector<std::uint8_t>{1, 0, 1, 1, 0}));
  EXPECT_EQ(made.strata->levels, (Names{"bright", "dark", "dim"}));
  EXPECT_EQ(made.cluster->codes, (std::vector<std::uint32_t>{0, 1, 0, 1, 0}));
  EXPECT_EQ(made.offset.value()[3], 4.0);
  EXPECT_EQ(made.weights.value()[4], 3.0);
  EXPECT_EQ(frame("Surv(time, status) ~ x + strata(w)").strata->levels,
            (Names{"w=1", "w=2", "w=3"}));
}

TEST(ModelFrame, MakesGroups) {
  FrameOptions options;
  options.right_side = RightSide::groups;
  EXPECT_EQ(frame("Surv(time, status) ~ 1", options).groups->levels, (Names{"all"}));
  EXPECT_EQ(frame("Surv(time, status) ~ id + w", options).groups->levels,
            (Names{"id=a, w=1", "id=a, w=2", "id=a, w=3", "id=b, w=1"}));
}

TEST(ModelFrame, NamesWhatIsWrongWithTheRows) {
  const auto first_of = [](const std::string& csv, const std::string& formula) {
    const ModelFrame made = model_frame(parse_formula(formula), table_of(csv));
    return made.conditions.empty() ? "none" : to_string(made.conditions.front());
  };
  EXPECT_EQ(
      first_of("x,t,s\n1,2,1\n2,-1,0\n3,0,1\n", "Surv(t, s) ~ x"),
      "error: column 't': a time that is not above 0: found -1 in row 2 (and 1 more); correct "
      "the cell or leave the row out");
  EXPECT_EQ(first_of("x,t,s\n1,2,1\n2,1,2\n", "Surv(t, s) ~ x"),
            "error: column 's': neither 0 nor 1: found 2 in row 2; write 'column == value' for the "
            "value that counts as 1");
  EXPECT_EQ(
      first_of("x,y\n1,1\nInf,0\n", "y ~ x"),
      "error: column 'x': an infinite value: found Inf in row 2; make the cell NA or correct it");
  EXPECT_EQ(first_of("x,y\nNA,1\nNaN,0\n", "y ~ x"),
            "note: column 'x': rows with a missing value are left out: 2 of 2 (x in 2)");
  EXPECT_EQ(
      first_of("a,b,e\n2,1,1\n", "Surv(a, b, e) ~ 1"),
      "error: column 'b': a start that is not before its stop: found start 2, stop 1 in row 1; "
      "correct the cells or leave the row out");
}

TEST(ModelFrame, ABinaryOutcomeIsZeroAndOne) {
  ModelFrame numbers = frame("y ~ x");
  require_binary(numbers);
  EXPECT_EQ(std::get<CountOutcome>(numbers.outcome).successes,
            (std::vector<double>{1, 0, 1, 0, 1}));
  ModelFrame names = frame("id ~ x");
  require_binary(names);
  EXPECT_EQ(std::get<CountOutcome>(names.outcome).successes, (std::vector<double>{0, 1, 0, 1, 0}));
  ModelFrame bad = frame("x ~ y");
  require_binary(bad);
  EXPECT_TRUE(has(bad.conditions, ConditionKind::not_binary));
}

TEST(ModelFrame, SaysWhatItDoesNotKnow) {
  EXPECT_EQ(problem_of("y ~ lihgt"), "no column 'lihgt' in test.csv; did you mean 'light'?");
  EXPECT_EQ(problem_of("y ~ log(light)"), "'log(light)' needs numbers, but 'light' holds text");
  EXPECT_EQ(problem_of("light ~ x"),
            "'light' has 3 levels; an outcome has two: write light == \"dim\"");
}

TEST(DataTable, TypesItsColumns) {
  const DataTable table = table_of("n,t,mixed,truth,q\n1.5,b,1,TRUE,\"x,y\"\n,a,two,false,z\n");
  EXPECT_FALSE(table.columns[0].is_text);
  EXPECT_TRUE(std::isnan(table.columns[0].numbers[1]));
  EXPECT_EQ(table.columns[1].text.levels, (Names{"a", "b"}));
  EXPECT_EQ(table.columns[1].text.codes, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_TRUE(table.columns[2].is_text);
  EXPECT_EQ(table.columns[3].numbers, (std::vector<double>{1, 0}));
  EXPECT_EQ(table.columns[4].text.levels, (Names{"x,y", "z"}));
}

TEST(DataTable, SaysWhatIsWrongWithTheFile) {
  CsvOptions options;
  options.file = "t.csv";
  const DataTableResult result = read_data_table(Bytes::copy_of("x,y\n1,2\n3\n4,5\n"), {}, options);
  EXPECT_FALSE(result.table.has_value());
  EXPECT_EQ(to_string(result.diagnostics.at(0)),
            "t.csv:3: error: found '1 fields', expected 2 fields, as the header has");
  const DataTableResult mixed =
      read_data_table(Bytes::copy_of("x,y\n1,2\n3,4\n4,5x\n"), {}, options);
  EXPECT_EQ(to_string(mixed.diagnostics.at(0)),
            "t.csv:4: warning: column 'y': found '5x', expected a number, as in its 2 other cells; "
            "the column is taken as text");
}

}  // namespace
}  // namespace tcert
