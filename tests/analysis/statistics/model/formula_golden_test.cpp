// What R's model.matrix says of right-hand sides (scripts/golden/formulas.R).

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/model/formula.hpp>
#include <statistics/model/new_rows.hpp>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

json golden() {
  std::ifstream file(std::string(TCERT_GOLDEN) + "/formulas.json");
  return json::parse(file);
}

table::DataTable table_of(const json& csv) {
  return test_support::table_of(csv.get<std::string>() + "\n");
}

ModelFrame frame_of(const std::string& right, const table::DataTable& table) {
  return model_frame(parse_formula("y ~ " + right), table, {});
}

TEST(FormulaGolden, ColumnsAndNamesAreThoseOfModelMatrix) {
  const json all = golden();
  const table::DataTable table = table_of(all["csv"]);
  for (const json& one : all["cases"]) {
    SCOPED_TRACE(one["formula"].get<std::string>());
    const ModelFrame frame = frame_of(one["formula"], table);
    EXPECT_EQ(frame.columns, one["columns"].get<std::vector<std::string>>());
    ASSERT_EQ(frame.columns.size(), one["columns"].size());
    for (std::size_t j = 0; j < frame.columns.size(); ++j) {
      for (std::size_t row = 0; row < frame.size(); ++row) {
        const auto expected = one["values"][j][row].get<double>();
        EXPECT_NEAR(frame.design(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(j)),
                    expected,
                    1e-12 * std::max(1.0, std::abs(expected)))
            << frame.columns[j] << " row " << row;
      }
    }
  }
  EXPECT_GT(all["cases"].size(), 25U);
}

/// Knots, boundaries and orthogonal powers are those of the rows of the fit, also beyond them.
TEST(FormulaGolden, PredictionsLearnFromTheRowsOfTheFitAlone) {
  const json all = golden();
  const table::DataTable table = table_of(all["csv"]);
  const table::DataTable others = table_of(all["new"]);
  for (const json& one : all["predictions"]) {
    SCOPED_TRACE(one["formula"].get<std::string>());
    const Formula formula = parse_formula("y ~ " + one["formula"].get<std::string>());
    const ModelFrame frame = model_frame(formula, table, {});
    const LogisticFit fit = fit_logistic(logistic_input(frame));
    const NewRows rows = new_rows(formula, table, frame, others, {});
    ASSERT_EQ(rows.design.rows(), 3);
    for (Eigen::Index row = 0; row < 3; ++row) {
      double eta = 0.0;
      for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
        eta += rows.design(row, static_cast<Eigen::Index>(j)) * *fit.coefficients[j].estimate;
      }
      const auto expected = one["eta"][static_cast<std::size_t>(row)].get<double>();
      EXPECT_NEAR(eta, expected, 1e-7 * std::max(1.0, std::abs(expected)));
    }
  }
}

TEST(FormulaErrors, SayWhatIsWrongWithACall) {
  const table::DataTable table = table_of(golden()["csv"]);
  const auto expect_error = [&](const std::string& right, const std::string& text) {
    try {
      static_cast<void>(frame_of(right, table));
      ADD_FAILURE() << right << " is taken";
    } catch (const FormulaError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  };
  expect_error("log(x, foot = 2)", "no argument 'foot'");
  expect_error("log(x, 1)", "not 1");
  expect_error("ns(x, df = 0)", "whole number");
  expect_error("ns(x, knots = 99)", "within the range");
  expect_error("poly(k, 7)", "more different numbers");
  expect_error("cut(x, 1)", "a number of them");
  expect_error("cut(x, c(1, 1))", "differ");
  expect_error("cut(x, c(1, 2), labels = c(\"a\", \"b\"))", "as many labels");
  expect_error("pmin(x)", "two arguments");
  expect_error("light %in% c(1, 2)", "c() of texts");
  expect_error("I(poly(x, 2) + 1)", "stands by itself");
  expect_error("ns(light, 2)", "holds text");
}

}  // namespace
}  // namespace tcert::statistics
