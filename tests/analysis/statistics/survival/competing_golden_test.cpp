// What R says of competing end points and restricted means (scripts/golden/competing.R).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/survival/fine_gray.hpp>
#include <statistics/survival/gray_test.hpp>
#include <statistics/survival/restricted_means.hpp>

#include "analysis/statistics/golden_table.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

json golden() { return golden_json("competing.json"); }

table::Factor factor_of(const json& all, const std::string& column) {
  const std::vector<std::string> cells = golden_texts(all).at(column);
  table::Factor factor;
  factor.levels = cells;
  std::sort(factor.levels.begin(), factor.levels.end());
  factor.levels.erase(std::unique(factor.levels.begin(), factor.levels.end()), factor.levels.end());
  for (const std::string& cell : cells) {
    const auto at = std::lower_bound(factor.levels.begin(), factor.levels.end(), cell);
    factor.codes.push_back(static_cast<std::uint32_t>(at - factor.levels.begin()));
  }
  return factor;
}

CompetingOutcome outcome_of(const json& all) {
  CompetingOutcome outcome;
  outcome.stop = golden_numbers(all, "time");
  const std::vector<double> causes = golden_numbers(all, "cause");
  for (const double cause : causes) {
    outcome.cause.push_back(static_cast<std::uint32_t>(cause));
  }
  outcome.causes = {"one", "two"};
  return outcome;
}

CoxData data_of(const json& all, bool strata) {
  CoxData data;
  data.outcome.stop = golden_numbers(all, "time");
  data.outcome.event.assign(data.outcome.stop.size(), 0);
  data.columns = data.terms = {"x", "z"};
  data.term_of = {0, 1};
  data.design.resize(static_cast<Eigen::Index>(data.outcome.stop.size()), 2);
  for (Eigen::Index j = 0; j < 2; ++j) {
    const std::vector<double> x = golden_numbers(all, data.columns[static_cast<std::size_t>(j)]);
    data.design.col(j) = Eigen::Map<const Eigen::VectorXd>(x.data(), data.design.rows());
  }
  if (strata) {
    data.strata = factor_of(all, "stratum");
  }
  return data;
}

TEST(CompetingGolden, GraysTestEqualsCmprsk) {
  const json all = golden();
  const table::Factor strata = factor_of(all, "stratum");
  for (const json& one : all["gray"]) {
    for (std::size_t cause = 0; cause < 2; ++cause) {
      const GrayTest test = gray_test(outcome_of(all),
                                      cause,
                                      factor_of(all, "group"),
                                      one["strata"].get<bool>() ? &strata : nullptr,
                                      one["rho"].get<double>());
      ASSERT_TRUE(test.test);
      EXPECT_NEAR(test.test->statistic, one["statistic"][cause].get<double>(), 1e-10);
      EXPECT_NEAR(test.test->p_value, one["p"][cause].get<double>(), 1e-10);
      EXPECT_NEAR(test.scores.sum(), 0.0, 1e-10);
    }
  }
}

TEST(CompetingGolden, TheFineGrayModelEqualsSurvival) {
  const json all = golden();
  for (const json& one : all["fine_gray"]) {
    SCOPED_TRACE(one.dump());
    CoxOptions options;
    options.ties = one["ties"] == "breslow" ? Ties::breslow : Ties::efron;
    for (const char* const by : {"by_row", "by_day"}) {
      CoxData data = data_of(all, one["strata"].get<bool>());
      if (by == std::string("by_day")) {
        data.cluster = levels_by_value(golden_numbers(all, "day"));
      }
      const CoxFit fit = fit_cox(fine_gray_data(data, outcome_of(all), 0), options);
      for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_NEAR(*fit.coefficients[j].estimate, one["estimate"][j].get<double>(), 1e-8);
        EXPECT_NEAR(*fit.coefficients[j].robust_se, one[by][j].get<double>(), 1e-8) << by;
      }
    }
  }
}

/// Without censoring before the last event nothing is weighted: who has had another event stays.
TEST(FineGray, WithoutCensoringOthersStayAtRiskToTheEnd) {
  CompetingOutcome outcome{{}, {1.0, 2.0, 3.0, 4.0, 5.0}, {2, 1, 2, 1, 0}, {"one", "two"}};
  CoxData data;
  data.outcome = {{}, outcome.stop, {0, 0, 0, 0, 0}};
  data.columns = data.terms = {"x"};
  data.term_of = {0};
  data.design.resize(5, 1);
  data.design << 0.3, 1.0, -0.5, 0.2, 0.9;
  const CoxFit weighted = fit_cox(fine_gray_data(data, outcome, 0));
  data.outcome.stop = {9.0, 2.0, 9.0, 4.0, 9.0};
  data.outcome.event = {0, 1, 0, 1, 0};
  EXPECT_NEAR(*weighted.coefficients[0].estimate, *fit_cox(data).coefficients[0].estimate, 1e-10);
}

TEST(CompetingGolden, RestrictedMeansEqualSurvival) {
  const json all = golden();
  const json& r = all["rmst"];
  const std::vector<double> cause = golden_numbers(all, "cause");
  SurvivalOutcome outcome{{}, golden_numbers(all, "time"), {}};
  for (const double one : cause) {
    outcome.event.push_back(one > 0.0 ? 1 : 0);
  }
  const table::Factor group = factor_of(all, "group");
  const table::Factor day = levels_by_value(golden_numbers(all, "day"));
  const auto limit = r["limit"].get<double>();
  const auto by_row = restricted_means(outcome, &group, nullptr, limit, 0.95);
  const auto by_day = restricted_means(outcome, &group, &day, limit, 0.95);
  ASSERT_EQ(by_row.size(), 6U);
  for (std::size_t g = 0; g < 3; ++g) {
    EXPECT_NEAR(by_row[g].value, r["mean"][g].get<double>(), 1e-10);
    EXPECT_NEAR(*by_row[g].spread.standard_error, r["se"][g].get<double>(), 1e-10);
    EXPECT_NEAR(*by_day[g].spread.standard_error, r["by_day"][g].get<double>(), 1e-10);
    const std::size_t pair = 3 + g;
    EXPECT_NEAR(by_row[pair].value, r["difference"][g].get<double>(), 1e-10);
    EXPECT_NEAR(*by_row[pair].spread.standard_error, r["difference_se"][g].get<double>(), 1e-10);
    EXPECT_NEAR(
        *by_day[pair].spread.standard_error, r["difference_by_day"][g].get<double>(), 1e-10);
    // Groups a and c lie on 12 days, b on 11.
    EXPECT_EQ(*by_day[pair].spread.df, g == 1 ? 11.0 : 10.0);
  }
}

}  // namespace
}  // namespace tcert::statistics
