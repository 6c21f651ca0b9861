#include <statistics/model/outcome_coding.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

using test_support::table_of;
using Values = std::vector<double>;
using Words = std::vector<std::string>;

std::string problem_of(const std::string& csv,
                       const std::string& column,
                       const Words& success = {}) {
  try {
    static_cast<void>(code_outcome(table_of(csv), column, success));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return "no problem";
}

std::string frame_problem(const std::string& csv, const std::string& formula) {
  try {
    static_cast<void>(model_frame(parse_formula(formula), table_of(csv)));
  } catch (const FormulaError& error) {
    return error.what();
  }
  return "no problem";
}

Values outcome_of(const std::string& csv,
                  const std::string& formula,
                  const FrameOptions& options = {}) {
  const ModelFrame frame = model_frame(parse_formula(formula), table_of(csv), options);
  return std::get<NumberOutcome>(frame.outcome).values;
}

TEST(OutcomeCoding, ReadsEverybodysWords) {
  for (const char* pair : {"1,0",
                           "True,False",
                           "TRUE,FALSE",
                           "s,f",
                           "ok,fail",
                           "Success,failure",
                           "pass,Fail",
                           "yes,no",
                           "OK,error"}) {
    const std::string words = pair;
    const std::string one = words.substr(0, words.find(','));
    const std::string zero = words.substr(words.find(',') + 1);
    const std::string csv = "y,x\n" + zero + ",1\n" + one + ",2\n" + one + ",3\n" + zero + ",5\n";
    if (zero != "error") {
      EXPECT_EQ(code_outcome(table_of(csv), "y").values, (Values{0, 1, 1, 0})) << pair;
      EXPECT_EQ(outcome_of(csv, "y ~ x"), (Values{0, 1, 1, 0})) << pair;
    } else {
      EXPECT_NE(problem_of(csv, "y").find("row 1 (line 2): found 'error', expected an outcome"),
                std::string::npos);
    }
  }
  // R's order of bytes would make 'failure' the event.
  const ModelFrame frame =
      model_frame(parse_formula("y ~ x"), table_of("y,x\nSuccess,1\nfailure,2\nfailure,0\nNA,1\n"));
  EXPECT_EQ(frame.outcome_levels, (Words{"failure", "Success"}));
  EXPECT_EQ(std::get<NumberOutcome>(frame.outcome).values, (Values{1, 0, 0}));
}

TEST(OutcomeCoding, SeveralWordsOfOneMeaningAreOneClass) {
  const std::string csv = "y,x\nok,1\nOK,2\nfail,3\nfailed,4\n";
  EXPECT_EQ(outcome_of(csv, "y ~ x"), (Values{1, 1, 0, 0}));
  const OutcomeCoding coding = code_outcome(table_of(csv), "y");
  EXPECT_EQ(coding.success, "OK, ok");
  EXPECT_EQ(coding.failure, "fail, failed");
}

TEST(OutcomeCoding, AnExplicitOrderGoesBeforeTheWords) {
  const std::string csv = "y,x\nok,1\nfail,2\n";
  FrameOptions options;
  options.reference["y"] = "ok";
  EXPECT_EQ(outcome_of(csv, "y ~ x", options), (Values{0, 1}));
  EXPECT_EQ(outcome_of("y,x\nSuccess,1\nfailure,2\n", "factor(y) ~ x"), (Values{0, 1}));
}

TEST(OutcomeCoding, AStatusIsReadAlike) {
  const ModelFrame frame = model_frame(parse_formula("Surv(t, s) ~ x"),
                                       table_of("t,s,x\n1,Success,1\n2,failure,2\n3,failure,0\n"));
  EXPECT_EQ(std::get<SurvivalOutcome>(frame.outcome).event, (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST(OutcomeCoding, NamedWordsAreTheSuccesses) {
  const std::string csv = "status,n\ngoal,1\nwedged,2\ndone,3\nNA,1\n";
  const OutcomeCoding coding = code_outcome(table_of(csv), "status", {"goal", "done"});
  EXPECT_EQ(coding.success, "done, goal");
  EXPECT_EQ(coding.failure, "wedged");
  EXPECT_EQ(coding.values[0], 1.0);
  EXPECT_EQ(coding.values[1], 0.0);
  EXPECT_EQ(coding.values[2], 1.0);
  EXPECT_TRUE(std::isnan(coding.values[3])) << "missing is missing, not a failure";
  EXPECT_EQ(code_outcome(table_of(csv), "n", {"2"}).values, (Values{0, 1, 0, 0}));
  const table::DataTable truths = table_of("y\nTrue\nFalse\nTrue\n");
  EXPECT_EQ(code_outcome(truths, "y", {"FALSE"}).values, (Values{0, 1, 0}));
  EXPECT_EQ(problem_of(csv, "status", {"gaol"}),
            "column 'status' of test.csv holds no 'gaol', only done, goal, wedged");
  EXPECT_EQ(problem_of(csv, "n", {"7"}), "column 'n' of test.csv holds no '7'");
  EXPECT_EQ(problem_of("s,x\ngoal,1\nN/A,2\n", "s", {"goal"}),
            "column 's' of test.csv, row 2 (line 3): found 'N/A', expected an outcome; a missing "
            "cell is empty, NA or nan");
}

TEST(OutcomeCoding, NamesWhatIsNoOutcome) {
  EXPECT_NE(problem_of("y\n1\n2\n", "y").find("row 2 (line 3): found '2', expected an outcome"),
            std::string::npos);
  EXPECT_EQ(problem_of("success\n1\n", "sucess"),
            "no column 'sucess' in test.csv; did you mean 'success'?");
  EXPECT_NE(frame_problem("y,x\nok,1\nN/A,2\nfail,1\n", "y ~ x").find("holds 'N/A', which is no"),
            std::string::npos);
  EXPECT_NE(frame_problem("y,x\nTrue,1\nNone,2\nFalse,1\n", "y ~ x")
                .find("'None' in row 2 of column y of test.csv (line 3; 1 such cell beside 2 truth "
                      "values) is not TRUE or FALSE; a missing cell is empty, NA or nan"),
            std::string::npos);
  EXPECT_NE(frame_problem("y,x\n1,1\nnull,2\n0,1\n", "y ~ x").find("'null' in row 2"),
            std::string::npos);
}

/// Each N/A would count as a failure without a word, or as a success of !=.
TEST(OutcomeCoding, AWordForAMissingCellIsNoOtherText) {
  const std::string csv = "y,t,x\ns,1,1\nf,2,2\nN/A,3,3\ns,4,4\nf,5,0\n";
  for (const char* formula : {"y == \"s\" ~ x",
                              "y != \"s\" ~ x",
                              "I(1 - (y == \"s\")) ~ x",
                              "Surv(t, y == \"s\") ~ x",
                              "x ~ I(y == \"s\")",
                              "factor(y) == \"s\" ~ x"}) {
    const std::string problem = frame_problem(csv, formula);
    EXPECT_NE(problem.find("found 'N/A' in row 3 of test.csv (line 4)"), std::string::npos)
        << formula << ": " << problem;
    EXPECT_NE(problem.find("a missing cell is empty, NA or nan"), std::string::npos) << problem;
  }
  // The refusal of the column itself does not advise what is refused too.
  const std::string refused = frame_problem(csv, "y ~ x");
  EXPECT_NE(refused.find("holds 'N/A', which is no outcome"), std::string::npos) << refused;
  EXPECT_EQ(refused.find("write y =="), std::string::npos) << refused;
  // Whoever names the word means it; and a cell that is missing stays so.
  EXPECT_EQ(outcome_of(csv, "y == \"N/A\" ~ x"), (Values{0, 0, 1, 0, 0}));
  EXPECT_EQ(outcome_of("y,x\ns,1\nf,2\nNA,3\n", "y == \"s\" ~ x"), (Values{1, 0}));
}

// ---- TRUE and FALSE ----

TEST(TruthValues, AreComparedWithRsConstants) {
  for (const char* spelling : {"TRUE,FALSE", "True,False", "true,false", "T,F", "1,0"}) {
    const std::string words = spelling;
    const std::string one = words.substr(0, words.find(','));
    const std::string zero = words.substr(words.find(',') + 1);
    const std::string csv = "t,s,x\n1," + one + ",1\n2," + zero + ",2\n3," + one + ",0\n";
    for (const char* constant : {"TRUE", "T"}) {
      const ModelFrame frame = model_frame(
          parse_formula("Surv(t, s == " + std::string(constant) + ") ~ x"), table_of(csv));
      EXPECT_EQ(std::get<SurvivalOutcome>(frame.outcome).event,
                (std::vector<std::uint8_t>{1, 0, 1}))
          << spelling << constant;
    }
    const ModelFrame other = model_frame(parse_formula("Surv(t, s == FALSE) ~ x"), table_of(csv));
    EXPECT_EQ(std::get<SurvivalOutcome>(other.outcome).event, (std::vector<std::uint8_t>{0, 1, 0}));
  }
  EXPECT_EQ(frame_problem("t,s,x\n1,s,1\n2,f,2\n", "Surv(t, s == TRUE) ~ x"),
            "'s == TRUE' needs numbers, but 's' holds text, not TRUE and FALSE; write s == \"s\" "
            "for the text that counts as TRUE");
  // A column that is called so goes first.
  EXPECT_EQ(outcome_of("y,TRUE\n0,1\n1,1\n", "y == TRUE ~ 1"), (Values{0, 1}));
  EXPECT_EQ(frame_problem("y,t\n0,1\n1,2\n", "y ~ T"),
            "no column 'T' in test.csv; did you mean 't'?");
}

TEST(TruthValues, TakeAReferenceInAnySpelling) {
  const std::string csv = "y,b\n1,True\n0,False\n1,False\n0,True\n";
  for (const char* word : {"FALSE", "False", "false", "F"}) {
    FrameOptions options;
    options.reference["b"] = word;
    EXPECT_EQ(model_frame(parse_formula("y ~ b"), table_of(csv), options).columns[1], "bTRUE");
    // In a comparison it stays a truth value.
    EXPECT_EQ(model_frame(parse_formula("y ~ I(b == TRUE)"), table_of(csv), options).columns[1],
              "I(b == TRUE)TRUE");
  }
  FrameOptions options;
  options.reference["b"] = "true";
  EXPECT_EQ(model_frame(parse_formula("y ~ b"), table_of(csv), options).columns[1], "bFALSE");
}

// ---- Levels of numbers ----

TEST(LevelsOfNumbers, ThatPrintAlikeTo15DigitsAreOne) {
  // R: levels(factor(c(0.1 + 0.2, 0.3, 1/3, 0.333333333333333, 1e5, 1e5 + 1e-9, 2)))
  const std::string csv =
      "y,g\n0,0.30000000000000004\n1,0.3\n0,0.3333333333333333\n1,0.333333333333333\n0,100000\n"
      "1,100000.000000001\n0,2\n1,-0\n0,0\n";
  const ModelFrame frame = model_frame(parse_formula("y ~ factor(g)"), table_of(csv));
  EXPECT_EQ(frame.columns,
            (Words{"(Intercept)",
                   "factor(g)0.3",
                   "factor(g)0.333333333333333",
                   "factor(g)2",
                   "factor(g)1e+05",
                   "factor(g)100000.000000001"}));
  FrameOptions options;
  options.cluster = "g";
  options.strata = "g";
  const ModelFrame grouped = model_frame(parse_formula("y ~ 1"), table_of(csv), options);
  EXPECT_EQ(grouped.cluster->levels.size(), 6U);
  EXPECT_EQ(grouped.cluster->codes[0], grouped.cluster->codes[1]);
  EXPECT_EQ(grouped.strata->levels.size(), 6U);
}

// ---- Stray texts ----

std::string column_of(const std::string& word, int share, int distinct) {
  std::string csv = "y,x\n";
  for (int row = 0; row < 60; ++row) {
    csv += std::to_string(row % 2) + ',' +
           (row % share == 1 ? word : "0." + std::to_string(100 + row % distinct)) + '\n';
  }
  return csv;
}

TEST(StrayText, IsRefusedHoweverManyThereAre) {
  for (const char* word : {"N/A", "null", "None", "-", "na", "wide"}) {
    for (const int share : {60, 5, 3, 2}) {
      const std::string problem = frame_problem(column_of(word, share, 60), "y ~ x");
      EXPECT_EQ(
          problem.find("'" + std::string(word) + "' in row 2 of column x of test.csv (line 3"), 0U)
          << word << share << problem;
      EXPECT_NE(problem.find("a missing cell is empty, NA or nan; write factor(x) if it is a name"),
                std::string::npos)
          << problem;
    }
  }
  EXPECT_EQ(frame_problem(column_of("-nan", 3, 60), "y ~ x"), "no problem");
  EXPECT_EQ(frame_problem(column_of("N/A", 3, 60), "y ~ factor(x)"), "no problem");
  EXPECT_NE(frame_problem(column_of("N/A", 3, 60), "y ~ I(x)"), "no problem");
  EXPECT_NE(frame_problem(column_of("N/A", 3, 60), "y ~ log(x)").find("'N/A' in row 2"),
            std::string::npos);
  EXPECT_NE(frame_problem(column_of("N/A", 3, 60), "y ~ offset(x)").find("'N/A' in row 2"),
            std::string::npos);
}

TEST(StrayText, LeavesTrueFactorsAlone) {
  std::string csv = "y,x\n";
  for (int row = 0; row < 60; ++row) {
    const char* const levels[] = {"1", "2", "a"};
    csv += std::to_string(row % 2) + ',' + levels[row % 3] + '\n';
  }
  EXPECT_EQ(model_frame(parse_formula("y ~ x"), table_of(csv)).columns,
            (Words{"(Intercept)", "x2", "xa"}));
  EXPECT_EQ(frame_problem("y,x\n1,F\n0,M\n1,F\n0,F\n1,F\n1,F\n", "y ~ x"), "no problem");
}

TEST(StrayText, AWordForAMissingCellIsNoGroupOfNumbers) {
  const std::string csv = "y,day\n1,1\n0,2\n1,N/A\n0,2\n";
  FrameOptions options;
  options.cluster = "day";
  EXPECT_THROW(static_cast<void>(model_frame(parse_formula("y ~ 1"), table_of(csv), options)),
               FormulaError);
}

}  // namespace
}  // namespace tcert::statistics
