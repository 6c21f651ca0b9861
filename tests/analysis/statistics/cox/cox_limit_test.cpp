// A coefficient that runs to infinity leaves limits: against R, and against the rows that are left.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <statistics/cox/cox.hpp>
#include <statistics/cox/cox_baseline.hpp>
#include <statistics/cox/cox_residuals.hpp>
#include <statistics/cox/cox_terms.hpp>
#include <statistics/cox/cox_zph.hpp>
#include <string>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

/// No row of group c has its event.
const std::string kTrials =
    "t,e,x,g\n8.5,0,-1.6,c\n70.4,1,0.0,a\n0.7,1,0.9,a\n42.5,0,-0.9,c\n25.1,0,0.9,c\n9.0,1,-0.3,a\n"
    "1.4,1,-2.2,a\n13.3,0,0.9,c\n5.2,1,0.7,b\n2.0,1,0.2,b\n8.5,1,0.8,a\n8.8,0,-0.2,c\n"
    "12.0,1,-0.8,a\n11.4,1,0.5,a\n28.3,0,0.2,b\n14.4,1,0.5,b\n13.4,0,-0.2,c\n0.6,0,0.4,c\n"
    "10.5,1,1.5,a\n13.9,0,0.1,c\n20.6,1,-0.8,a\n6.8,1,2.3,b\n3.3,0,-0.1,c\n8.5,1,-2.0,a\n"
    "27.9,0,0.5,c\n7.7,1,1.7,b\n29.7,1,-0.8,a\n9.7,1,-1.1,b\n3.3,1,-0.6,a\n45.8,1,0.8,a\n";

CoxData data_of(const std::string& csv, const std::string& formula, References reference = {}) {
  FrameOptions options;
  options.reference = std::move(reference);
  return cox_data(model_frame(parse_formula(formula), test_support::table_of(csv), options));
}

/// Its lines without those that end with ",c".
std::string without_c(const std::string& csv) {
  std::string kept;
  for (std::size_t begin = 0; begin < csv.size();) {
    const std::size_t end = csv.find('\n', begin) + 1;
    const std::string line = csv.substr(begin, end - begin);
    kept += line.ends_with(",c\n") ? "" : line;
    begin = end;
  }
  return kept;
}

/// As R 4.2.2 with survival 3.5-3 prints them: drop1, anova, cox.zph, of coxph(Surv(t, e) ~ g + x).
TEST(CoxLimit, TestsEqualR) {
  const CoxData data = data_of(kTrials, "Surv(t, e) ~ g + x");
  const CoxFit fit = fit_cox(data);
  ASSERT_EQ(fit.summary.termination, CoxTermination::monotone);
  ASSERT_TRUE(fit.at_limit);
  EXPECT_TRUE(fit.coefficients[1].is_infinite);
  EXPECT_FALSE(fit.coefficients[0].is_infinite);

  const TermTests drop1 = cox_drop1(data);
  ASSERT_EQ(drop1.rows.size(), 3U);
  EXPECT_NEAR(drop1.rows[0].aic, 87.479420, 1e-6);
  EXPECT_NEAR(drop1.rows[1].test.value().statistic, 15.6462008, 1e-6);
  EXPECT_EQ(drop1.rows[1].test.value().df, 2U);
  EXPECT_NEAR(drop1.rows[1].test.value().p_value, 0.00040038, 1e-8);
  EXPECT_NEAR(drop1.rows[2].test.value().statistic, 5.37833373485e-04, 1e-8);

  const TermTests anova = cox_anova(data);
  ASSERT_EQ(anova.rows.size(), 3U);
  EXPECT_NEAR(anova.rows[1].loglik, -40.73997901, 1e-7);
  EXPECT_NEAR(anova.rows[1].test.value().statistic, 15.66453, 1e-5);
  EXPECT_NEAR(anova.rows[2].loglik, -40.73971010, 1e-7);

  const ProportionalityTests zph = cox_zph(data, fit);
  ASSERT_EQ(zph.parts.size(), 2U);
  EXPECT_NEAR(zph.parts[0].test.value().statistic, 0.004956676312, 1e-8);
  EXPECT_EQ(zph.parts[0].test.value().df, 2U);
  EXPECT_NEAR(zph.parts[0].test.value().p_value, 0.9975247304, 1e-8);
  EXPECT_NEAR(zph.parts[1].test.value().statistic, 0.006054746606, 1e-8);
  EXPECT_NEAR(zph.global.value().statistic, 0.008411074646, 1e-8);
  EXPECT_EQ(zph.global.value().df, 3U);
  const ProportionalityTests columns = cox_zph(data, fit, TimeTransform::km, false);
  ASSERT_EQ(columns.parts.size(), 3U);
  EXPECT_FALSE(columns.parts[1].test.has_value());
}

TEST(CoxLimit, HazardsResidualsAndCurvesEqualR) {
  const CoxData data = data_of(kTrials, "Surv(t, e) ~ g + x");
  const CoxFit fit = fit_cox(data);
  const std::vector<BaselineHazard> baseline = cox_baseline(data, fit);
  ASSERT_EQ(baseline.size(), 1U);
  const auto hazard_at = [&](double time) {
    const auto& times = baseline[0].time;
    return baseline[0].hazard[static_cast<std::size_t>(std::find(times.begin(), times.end(), time) -
                                                       times.begin())];
  };
  EXPECT_NEAR(hazard_at(3.3), 0.1887913247, 1e-8);
  EXPECT_NEAR(hazard_at(12.0), 1.0248026236, 1e-8);
  EXPECT_NEAR(hazard_at(42.5), 1.6892888193, 1e-8);

  const CoxResiduals residuals = cox_residuals(data, fit);
  EXPECT_NEAR(residuals.martingale(0), 0.0, 1e-8);
  EXPECT_NEAR(residuals.martingale(1), -2.190576414, 1e-8);
  EXPECT_NEAR(residuals.martingale(2), 0.9565260857, 1e-8);
  EXPECT_NEAR(residuals.martingale(5), 0.4058940806, 1e-8);
  EXPECT_NEAR(residuals.dfbeta(1, 0), 1.315721568e-01, 1e-8);
  EXPECT_TRUE(std::isnan(residuals.dfbeta(1, 1)));
  EXPECT_NEAR(residuals.dfbeta(2, 2), 7.181116443e-02, 1e-8);

  const std::vector<CoxCurve> curves = cox_curves(data, fit, data.design.topRows(3));
  ASSERT_EQ(curves.size(), 3U);
  const std::size_t at = static_cast<std::size_t>(
      std::find(curves[0].time.begin(), curves[0].time.end(), 12.0) - curves[0].time.begin());
  EXPECT_EQ(curves[0].survival[at], 1.0);
  EXPECT_NEAR(curves[1].survival[at], 0.3588672903, 1e-8);
  EXPECT_NEAR(curves[1].std_err[at], 0.12626808633, 1e-8);
  EXPECT_NEAR(curves[2].survival[at], 0.3609983489, 1e-8);
  EXPECT_NEAR(curves[2].std_err[at], 0.16422289926, 1e-8);
}

/// Rows whose risk vanishes are as good as absent.
TEST(CoxLimit, EqualsTheFitOfTheRowsThatAreLeft) {
  for (const Ties ties : {Ties::efron, Ties::breslow}) {
    CoxOptions options;
    options.ties = ties;
    const CoxData whole = data_of(kTrials, "Surv(t, e) ~ g + x");
    const CoxData left = data_of(without_c(kTrials), "Surv(t, e) ~ g + x");
    const CoxFit limit = fit_cox(whole, options);
    const CoxFit fit = fit_cox(left, options);
    ASSERT_EQ(fit.summary.termination, CoxTermination::converged);
    EXPECT_NEAR(limit.loglik.value(), fit.loglik.value(), 1e-9);
    EXPECT_NEAR(limit.coefficients[2].model_se.value(), fit.coefficients[1].model_se.value(), 1e-9);
    EXPECT_NEAR(cox_zph(whole, limit, TimeTransform::identity).parts[1].test.value().statistic,
                cox_zph(left, fit, TimeTransform::identity).parts[1].test.value().statistic,
                1e-9);
    EXPECT_NEAR(cox_baseline(whole, limit)[0].hazard.back(),
                cox_baseline(left, fit)[0].hazard.back(),
                1e-8);
  }
}

/// With c for reference the others' coefficients run to +infinity: rows of c have no hazard, and
/// the curves of the others are what they were.
TEST(CoxLimit, DoesNotDependOnTheReference) {
  const CoxData data = data_of(kTrials, "Surv(t, e) ~ g + x");
  const CoxData turned = data_of(kTrials, "Surv(t, e) ~ g + x", {{"g", "c"}});
  const CoxFit fit = fit_cox(data);
  const CoxFit other = fit_cox(turned);
  ASSERT_EQ(other.summary.termination, CoxTermination::monotone);
  EXPECT_FALSE(other.coefficients[0].estimate.has_value());
  EXPECT_FALSE(other.coefficients[1].estimate.has_value());
  const std::vector<BaselineHazard> baseline = cox_baseline(turned, other);
  for (const double hazard : baseline[0].hazard) {
    EXPECT_EQ(hazard, 0.0);
  }
  const std::vector<CoxCurve> curves = cox_curves(data, fit, data.design);
  const std::vector<CoxCurve> same = cox_curves(turned, other, turned.design);
  for (std::size_t row = 0; row < curves.size(); ++row) {
    for (std::size_t k = 0; k < curves[row].time.size(); ++k) {
      EXPECT_NEAR(curves[row].survival[k], same[row].survival[k], 1e-9);
      EXPECT_NEAR(curves[row].std_err[k], same[row].std_err[k], 1e-7);
    }
  }
  const CoxResiduals a = cox_residuals(data, fit);
  const CoxResiduals b = cox_residuals(turned, other);
  EXPECT_LT((a.martingale - b.martingale).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((a.dfbeta.col(2) - b.dfbeta.col(2)).cwiseAbs().maxCoeff(), 1e-9);
}

/// Every row of group b has its event before any other: the baseline, of a row of a, begins when
/// they are gone; for a row of b it is infinite from then on.
TEST(CoxLimit, AHazardThatRunsToInfinityIsInfinite) {
  const std::string csv =
      "t,e,x,g\n1,1,0.3,b\n2,1,1.1,b\n3,1,0.2,b\n4,1,0.9,a\n5,0,0.4,a\n6,1,0.1,a\n7,1,0.8,a\n";
  const CoxData data = data_of(csv, "Surv(t, e) ~ g + x");
  const CoxFit fit = fit_cox(data);
  ASSERT_EQ(fit.summary.termination, CoxTermination::monotone);
  ASSERT_TRUE(fit.at_limit);
  const auto hazard = cox_baseline(data, fit)[0].hazard;
  EXPECT_EQ(hazard[2], 0.0);
  EXPECT_GT(hazard[3], 0.0);
  EXPECT_TRUE(std::isfinite(hazard[6]));
  const CoxData turned = data_of(csv, "Surv(t, e) ~ g + x", {{"g", "b"}});
  const auto other = cox_baseline(turned, fit_cox(turned))[0].hazard;
  EXPECT_TRUE(std::isfinite(other[2]));
  EXPECT_EQ(other[3], std::numeric_limits<double>::infinity());
  const auto curves = cox_curves(data, fit, data.design.topRows(1));
  EXPECT_GT(curves[0].survival[2], 0.0);
  EXPECT_EQ(curves[0].survival[3], 0.0);
}

/// Where a part has no finite coefficient there is nothing to test, and nothing is singular.
TEST(CoxLimit, APartThatIsInfiniteIsNotWarnedOfAsSingular) {
  const CoxData data = data_of(kTrials, "Surv(t, e) ~ I(g == \"c\") + x");
  const CoxFit fit = fit_cox(data);
  ASSERT_TRUE(fit.coefficients[0].is_infinite);
  const ProportionalityTests zph = cox_zph(data, fit);
  ASSERT_EQ(zph.parts.size(), 2U);
  EXPECT_FALSE(zph.parts[0].test.has_value());
  EXPECT_TRUE(zph.parts[1].test.has_value());
  EXPECT_EQ(zph.global.value().df, 2U);
  EXPECT_FALSE(has(zph.conditions, ConditionKind::singular_information));
}

/// Rows go in the order of x but for two, by a hair: its maximum is finite, and is tested as R
/// does, with its degree of freedom.
TEST(CoxLimit, AColumnThatHasRunAwayIsTested) {
  std::string csv = "t,e,x,z\n";
  for (int i = 0; i < 20; ++i) {
    const double x = i == 11 ? 0.50001 : 0.05 * (20 - i);
    csv += std::to_string(i + 1) + ",1," + std::to_string(i == 10 ? 0.5 : x) + ',' +
           std::to_string((i == 11 ? 10 : i) * 7 % 5) + '\n';
  }
  const CoxData data = data_of(csv, "Surv(t, e) ~ x + z");
  const CoxFit fit = fit_cox(data);
  ASSERT_TRUE(has(fit.conditions, ConditionKind::near_separation));
  ASSERT_FALSE(fit.coefficients[0].estimate.has_value());
  const ProportionalityTests zph = cox_zph(data, fit);
  ASSERT_EQ(zph.parts.size(), 2U);
  EXPECT_EQ(zph.parts[0].name, "x");
  ASSERT_TRUE(zph.parts[0].test.has_value());
  EXPECT_EQ(zph.parts[0].test->df, 1U);
  EXPECT_EQ(zph.parts[1].name, "z");
  ASSERT_TRUE(zph.global.has_value());
  EXPECT_EQ(zph.global->df, 2U);
  // R: cox.zph(coxph(Surv(t, e) ~ x + z, iter.max = 200, eps = 1e-11, toler.chol = 1e-13)).
  EXPECT_NEAR(zph.parts[0].test->statistic, 4.51094660612e-06, 1e-9);
  EXPECT_NEAR(zph.parts[1].test.value().statistic, 4.72202000105e-07, 1e-9);
  EXPECT_NEAR(zph.global->statistic, 4.52448005215e-06, 1e-9);
}

}  // namespace
}  // namespace tcert::statistics
