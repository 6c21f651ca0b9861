#include <statistics/model/model_frame.hpp>
#include <table/read_data_table.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {
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
  EXPECT_EQ(first_of("x,t,s\n1,2,1\n2,-1,0\n3,0,1\n", "Surv(t, s) ~ x"),
            "error: column 't': a time that is not above 0: found -1 in row 2 (line 3) (and 1 "
            "more); correct "
            "the cell or leave the row out");
  EXPECT_EQ(first_of("x,t,s\n1,2,1\n2,1,2\n", "Surv(t, s) ~ x"),
            "error: column 's': neither 0 nor 1: found 2 in row 2 (line 3); write 'column == "
            "value' for the "
            "value that counts as 1");
  EXPECT_EQ(first_of("x,y\n1,1\nInf,0\n", "y ~ x"),
            "error: column 'x': an infinite value: found Inf in row 2 (line 3); make the cell NA "
            "or correct it");
  EXPECT_EQ(first_of("x,y\nNA,1\nNaN,0\n", "y ~ x"),
            "note: column 'x': rows with a missing value are left out: 2 of 2 (x in 2)");
  EXPECT_EQ(first_of("a,b,e\n2,1,1\n", "Surv(a, b, e) ~ 1"),
            "error: column 'b': a start that is not before its stop: found start 2, stop 1 in row "
            "1 (line 2); "
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

// ---- Truth values: the numbers and names of R 4.2.2's model.matrix ----

constexpr const char* kTruths =
    "z,x,b,g,y\n1,10,TRUE,p,1\n2,20,FALSE,q,0\n3,30,TRUE,p,1\n4,40,TRUE,q,0\n5,50,FALSE,q,1\n";

ModelFrame truths(const std::string& formula, const FrameOptions& options = {}) {
  return model_frame(parse_formula(formula), table_of(kTruths), options);
}

TEST(ModelFrame, TruthValuesAreAFactorOfTwoLevels) {
  const ModelFrame alone = truths("y ~ I(z>2) - 1");
  EXPECT_EQ(alone.columns, (Names{"I(z > 2)FALSE", "I(z > 2)TRUE"}));
  Eigen::MatrixXd expected(5, 2);
  expected << 1, 0, 1, 0, 0, 1, 0, 1, 0, 1;
  EXPECT_EQ(alone.design, expected);

  const ModelFrame slopes = truths("y ~ x:I(z>3)");
  EXPECT_EQ(slopes.columns, (Names{"(Intercept)", "x:I(z > 3)FALSE", "x:I(z > 3)TRUE"}));
  expected.resize(5, 3);
  expected << 1, 10, 0, 1, 20, 0, 1, 30, 0, 1, 0, 40, 1, 0, 50;
  EXPECT_EQ(slopes.design, expected);

  const ModelFrame crossed = truths("y ~ b*g");
  EXPECT_EQ(crossed.columns, (Names{"(Intercept)", "bTRUE", "gq", "bTRUE:gq"}));
  expected.resize(5, 4);
  expected << 1, 1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 1, 1, 1, 0, 1, 0;
  EXPECT_EQ(crossed.design, expected);

  EXPECT_EQ(truths("y ~ b:g").columns,
            (Names{"(Intercept)", "bFALSE:gp", "bTRUE:gp", "bFALSE:gq", "bTRUE:gq"}));
  EXPECT_EQ(truths("y ~ b + g - 1").columns, (Names{"bFALSE", "bTRUE", "gq"}));
  EXPECT_EQ(truths("y ~ factor(b)").columns, (Names{"(Intercept)", "factor(b)TRUE"}));
  EXPECT_EQ(truths("y ~ I(z>0)").columns, (Names{"(Intercept)", "I(z > 0)TRUE"}));
  EXPECT_EQ(truths("y ~ I(b + 1)").columns, (Names{"(Intercept)", "I(b + 1)"}));
}

TEST(ModelFrame, TruthValuesAreComparedWithTheirWords) {
  Eigen::VectorXd b(5);
  b << 1, 0, 1, 1, 0;
  EXPECT_EQ(truths("y ~ I(b == \"TRUE\")").design.col(1), b);
  EXPECT_EQ(truths("y ~ I(b != \"false\")").design.col(1), b);
  EXPECT_THROW(static_cast<void>(truths("y ~ I(b == \"yes\")")), FormulaError);
  FrameOptions options;
  options.reference["b"] = "TRUE";
  EXPECT_EQ(truths("y ~ b", options).columns, (Names{"(Intercept)", "bFALSE"}));
  EXPECT_EQ(truths("y ~ b", options).design.col(1), Eigen::VectorXd(1.0 - b.array()));
}

// ---- Text where numbers are needed, and the other way around ----

std::string problem_of(const std::string& csv,
                       const std::string& formula,
                       const FrameOptions& options) {
  try {
    static_cast<void>(model_frame(parse_formula(formula), table_of(csv), options));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return "no problem";
}

TEST(ModelFrame, RefusesTextInPlaceOfNumbers) {
  FrameOptions weights;
  weights.weights = "id";
  EXPECT_EQ(problem_of("y ~ x", weights), "'id' of test.csv holds text, not numbers");
  EXPECT_EQ(problem_of("y ~ x + offset(id)"), "'id' of test.csv holds text, not numbers");
  EXPECT_EQ(problem_of("Surv(id, status) ~ x"), "'id' of test.csv holds text, not numbers");
  EXPECT_EQ(problem_of("Surv(id, time, status) ~ x"), "'id' of test.csv holds text, not numbers");
  EXPECT_EQ(problem_of("cbind(id, y) ~ x"), "'id' of test.csv holds text, not numbers");
  EXPECT_EQ(problem_of("cbind(y, id) ~ x"), "'id' of test.csv holds text, not numbers");
}

TEST(ModelFrame, AStatusOfTextKeepsItsMeaningWhenRowsAreLeftOut) {
  // The rows that are left all hold 'dead', the second level of the column.
  const std::string csv = "t,s,x\n1,alive,NA\n2,dead,1\n3,dead,2\n";
  const ModelFrame made = model_frame(parse_formula("Surv(t, s) ~ x"), table_of(csv));
  EXPECT_EQ(std::get<SurvivalOutcome>(made.outcome).event, (std::vector<std::uint8_t>{1, 1}));
  EXPECT_EQ(problem_of("t,s,x\n1,dead,1\n2,dead,2\n", "Surv(t, s) ~ x", {}),
            "'s' has 1 level; an outcome has two: write s == \"dead\"");
  EXPECT_EQ(problem_of("s,x\ndead,1\ndead,2\n", "s ~ x", {}),
            "'s' has 1 level; an outcome has two: write s == \"dead\"");
}

TEST(ModelFrame, ASingleStrayTextMakesNoFactor) {
  const std::string csv = "gap_mm,y\n1,0\n2,1\n3.5,0\nwide,1\n4,1\nNA,0\n";
  EXPECT_EQ(
      problem_of(csv, "y ~ gap_mm", {}),
      "'wide' in row 4 of column gap_mm of test.csv (line 5; 1 such cell beside 4 numbers) is "
      "not a number; a missing cell is empty, NA or nan; write factor(gap_mm) if it is a "
      "name");
  EXPECT_EQ(problem_of(csv, "y ~ factor(gap_mm)", {}), "no problem");
  EXPECT_EQ(problem_of("g,y\n1,0\n2,1\nA,0\nB,1\n", "y ~ g", {}), "no problem");
}

TEST(ModelFrame, InfinityTimesZeroIsMissing) {
  FrameOptions options;
  options.allow_infinite = true;
  const ModelFrame made = model_frame(
      parse_formula("y ~ x:z"), table_of("x,z,y\nInf,0,1\n2,3,0\nInf,1,1\n4,NA,0\n"), options);
  EXPECT_EQ(made.rows, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(made.dropped, 2U);
  EXPECT_FALSE(made.design.hasNaN());
  EXPECT_EQ(made.missing.back(), (std::pair<std::string, std::size_t>{"x:z", 1}));
}

TEST(ModelFrame, RefusesMoreGroupsThanCanBeCompared) {
  std::string csv = "t,s,g\n";
  for (int row = 0; row < 1001; ++row) {
    csv += "1,1," + std::to_string(row) + "\n";
  }
  FrameOptions options;
  options.right_side = RightSide::groups;
  EXPECT_EQ(problem_of(csv, "Surv(t, s) ~ g", options),
            "formula 'Surv(t, s) ~ g': 1001 groups to compare, at most 1000; did you mean cox?");
}

TEST(DataTable, TypesItsColumns) {
  const table::DataTable table =
      table_of("n,t,mixed,truth,q\n1.5,b,1,TRUE,\"x,y\"\n,a,two,false,z\n");
  EXPECT_FALSE(table.columns[0].is_text);
  EXPECT_TRUE(std::isnan(table.columns[0].numbers[1]));
  EXPECT_EQ(table.columns[1].text.levels, (Names{"a", "b"}));
  EXPECT_EQ(table.columns[1].text.codes, (std::vector<std::uint32_t>{1, 0}));
  EXPECT_TRUE(table.columns[2].is_text);
  EXPECT_EQ(table.columns[3].numbers, (std::vector<double>{1, 0}));
  EXPECT_TRUE(table.columns[3].is_truth);
  EXPECT_FALSE(table.columns[0].is_truth);
  EXPECT_EQ(table.columns[4].text.levels, (Names{"x,y", "z"}));
}

TEST(DataTable, SaysWhatIsWrongWithTheFile) {
  table::CsvOptions options;
  options.file = "t.csv";
  const table::DataTableResult result =
      table::read_data_table(table::Bytes::copy_of("x,y\n1,2\n3\n4,5\n"), {}, options);
  EXPECT_FALSE(result.table.has_value());
  EXPECT_EQ(table::to_string(result.diagnostics.at(0)),
            "t.csv:3: error: found '1 fields', expected 2 fields, as the header has");
  const table::DataTableResult mixed =
      table::read_data_table(table::Bytes::copy_of("x,y\n1,2\n3,4\n4,5x\n"), {}, options);
  EXPECT_EQ(table::to_string(mixed.diagnostics.at(0)),
            "t.csv:4: warning: column 'y': found '5x', expected a number, as in its 2 other cells; "
            "the column is taken as text");
}

}  // namespace
}  // namespace tcert::statistics
