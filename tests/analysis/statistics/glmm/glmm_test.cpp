// Mixed models: what is said about data that do not allow a fit, and what does not change it.

#include <statistics/glmm/glmm.hpp>

#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <statistics/glmm/glmm_comparison.hpp>
#include <statistics/glmm/glmm_profile.hpp>
#include <string>
#include <table/random.hpp>
#include <utility>
#include <vector>

#include "support/data_table.hpp"

namespace tcert::statistics {
namespace {

struct Trial {
  int day = 0;
  int run = 0;
  double x = 0.0;
  int y = 0;
};

/// Days differ by a shift of standard deviation `sd`.
std::vector<Trial> trials(int days, int per_day, double sd, std::uint64_t seed) {
  table::RandomStream random(seed, 9, 2);
  std::vector<Trial> all;
  for (int day = 0; day < days; ++day) {
    const double shift = sd * random.normal();
    for (int k = 0; k < per_day; ++k) {
      Trial trial{day, k % 3, random.normal(), 0};
      trial.y = random.uniform() < 1.0 / (1.0 + std::exp(-0.3 - 0.8 * trial.x - shift)) ? 1 : 0;
      all.push_back(trial);
    }
  }
  return all;
}

std::string csv_of(const std::vector<Trial>& all) {
  std::ostringstream csv;
  csv << "day,run,x,y,seven,twice\n";
  csv.precision(17);
  for (const Trial& trial : all) {
    csv << 'd' << trial.day << ",r" << trial.run << ',' << trial.x << ',' << trial.y << ",7,"
        << 2.0 * trial.x << '\n';
  }
  return csv.str();
}

GlmmInput input_of(const std::vector<Trial>& all, const std::string& formula) {
  return glmm_input(model_frame(parse_formula(formula), test_support::table_of(csv_of(all))));
}

GlmmFit fit_of(const std::vector<Trial>& all,
               const std::string& formula,
               const GlmmOptions& options = {}) {
  return fit_glmm(input_of(all, formula), options);
}

const Condition& condition(const GlmmFit& fit, ConditionKind kind) {
  static const Condition kNone{};
  const auto found = std::find_if(fit.conditions.begin(),
                                  fit.conditions.end(),
                                  [&](const Condition& one) { return one.kind == kind; });
  EXPECT_NE(found, fit.conditions.end()) << "no " << name_of(kind);
  return found == fit.conditions.end() ? kNone : *found;
}

void expect_no_estimate(const GlmmFit& fit) {
  EXPECT_TRUE(has_error(fit.conditions));
  EXPECT_FALSE(fit.log_likelihood.has_value());
  for (const LogisticCoefficient& one : fit.coefficients) {
    EXPECT_FALSE(one.estimate.has_value());
  }
}

TEST(Glmm, TakesFifteenPointsForOneInterceptAndLaplaceElse) {
  const std::vector<Trial> all = trials(12, 12, 1.0, 1);
  const GlmmFit one = fit_of(all, "y ~ x + (1 | day)");
  EXPECT_EQ(one.quadrature, 15);
  EXPECT_NE(*one.log_likelihood, *one.laplace_log_likelihood);
  const GlmmFit two = fit_of(all, "y ~ x + (1 | day) + (1 | run)");
  EXPECT_EQ(two.quadrature, 1);
  EXPECT_EQ(*two.log_likelihood, *two.laplace_log_likelihood);
  EXPECT_EQ(two.random.size(), 2U);
}

TEST(Glmm, ExplainedVarianceByHand) {
  const std::vector<Trial> all = trials(12, 12, 1.0, 2);
  const GlmmFit fit = fit_of(all, "y ~ x + (1 | day)");
  double mean = 0.0;
  for (const Trial& trial : all) {
    mean += trial.x / static_cast<double>(all.size());
  }
  double variance = 0.0;
  for (const Trial& trial : all) {
    variance += (trial.x - mean) * (trial.x - mean) / (static_cast<double>(all.size()) - 1.0);
  }
  const double slope = *fit.coefficients[1].estimate;
  const double fixed = slope * slope * variance;
  const double between = fit.random[0].sd[0] * fit.random[0].sd[0];
  const double latent = std::numbers::pi * std::numbers::pi / 3.0;
  EXPECT_NEAR(*fit.icc, between / (between + latent), 1e-14);
  EXPECT_NEAR(*fit.r2_marginal, fixed / (fixed + between + latent), 1e-13);
  EXPECT_NEAR(*fit.r2_conditional, (fixed + between) / (fixed + between + latent), 1e-13);
  EXPECT_NEAR(*fit.aic, 6.0 - 2.0 * *fit.log_likelihood, 1e-12);
  EXPECT_NEAR(*fit.bic, 3.0 * std::log(144.0) - 2.0 * *fit.log_likelihood, 1e-12);
}

TEST(Glmm, CountsAndRowsGiveOneLikelihoodUpToTheBinomialCoefficients) {
  const table::DataTable counts = test_support::table_of(
      "g,k,n\na,1,3\na,2,2\nb,0,2\nb,1,3\nc,3,4\nc,2,3\nd,1,4\nd,0,3\ne,3,3\ne,2,4\n");
  std::string rows = "g,y\n";
  for (std::size_t i = 0; i < counts.rows; ++i) {
    for (int trial = 0; trial < static_cast<int>(counts.find("n")->numbers[i]); ++trial) {
      rows += std::string(1, "aabbccddee"[i]) +
              (trial < static_cast<int>(counts.find("k")->numbers[i]) ? ",1\n" : ",0\n");
    }
  }
  // log of 3 * 1 * 1 * 3 * 4 * 3 * 4 * 1 * 1 * 6
  const double constant = std::log(3.0 * 3.0 * 4.0 * 3.0 * 4.0 * 6.0);
  for (const int quadrature : {1, 9}) {
    GlmmOptions options;
    options.quadrature = quadrature;
    const GlmmFit a = fit_glmm(
        glmm_input(model_frame(parse_formula("cbind(k, n - k) ~ 1 + (1 | g)"), counts)), options);
    const GlmmFit b = fit_glmm(
        glmm_input(model_frame(parse_formula("y ~ 1 + (1 | g)"), test_support::table_of(rows))),
        options);
    EXPECT_NEAR(*a.log_likelihood, *b.log_likelihood + constant, 1e-11);
    EXPECT_NEAR(a.random[0].sd[0], b.random[0].sd[0], 1e-7);
  }
}

TEST(Glmm, RowOrderAndThreadsDoNotMatter) {
  std::vector<Trial> all = trials(300, 30, 0.8, 3);
  const GlmmFit first = fit_of(all, "y ~ x + (1 | day)");
  {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const GlmmFit again = fit_of(all, "y ~ x + (1 | day)");
    EXPECT_EQ(*again.log_likelihood, *first.log_likelihood);
    EXPECT_EQ(*again.coefficients[1].estimate, *first.coefficients[1].estimate);
    EXPECT_EQ(again.covariance, first.covariance);
  }
  std::reverse(all.begin(), all.end());
  const GlmmFit reversed = fit_of(all, "y ~ x + (1 | day)");
  EXPECT_NEAR(*reversed.coefficients[1].estimate, *first.coefficients[1].estimate, 1e-10);
  EXPECT_NEAR(reversed.random[0].sd[0], first.random[0].sd[0], 1e-9);
}

TEST(Glmm, ScalesDoNotMatter) {
  std::vector<Trial> all = trials(15, 12, 1.0, 4);
  const GlmmFit plain = fit_of(all, "y ~ x + (1 + x | day)");
  const GlmmFit wild = fit_of(all, "y ~ I(x * 1e7 + 3e8) + (1 | day)");
  const GlmmFit tame = fit_of(all, "y ~ x + (1 | day)");
  EXPECT_NEAR(*wild.coefficients[1].estimate * 1e7, *tame.coefficients[1].estimate, 1e-7);
  const GlmmFit scaled = fit_of(all, "y ~ I(x * 1e-6) + (1 + I(x * 1e-6) | day)");
  EXPECT_NEAR(*scaled.log_likelihood, *plain.log_likelihood, 1e-9);
  EXPECT_NEAR(scaled.random[0].sd[1] * 1e-6, plain.random[0].sd[1], 1e-5);
}

TEST(Glmm, SingularFitIsNamedWithItsBoundaryP) {
  // Every day has the same outcomes: less than chance would give.
  std::vector<Trial> all;
  for (int day = 0; day < 10; ++day) {
    for (int k = 0; k < 8; ++k) {
      all.push_back({day, k % 2, 0.3 * k + 0.01 * day, (k % 4 == 1 || k > 5) ? 1 : 0});
    }
  }
  const GlmmFit fit = fit_of(all, "y ~ x + (1 | day)");
  EXPECT_TRUE(fit.singular);
  EXPECT_EQ(fit.random[0].sd[0], 0.0);
  EXPECT_EQ(fit.random[0].test.value().p_value, 1.0);
  const Condition& said = condition(fit, ConditionKind::singular_fit);
  EXPECT_EQ(said.column, "day");
  EXPECT_EQ(said.severity, ConditionSeverity::note);
  EXPECT_EQ(said.detail,
            "the standard deviation of (Intercept) is 0, boundary p = 1 for leaving out "
            "(Intercept)");
  const LogisticFit plain = fit_logistic(input_of(all, "y ~ x + (1 | day)").fixed);
  EXPECT_NEAR(*fit.coefficients[1].standard_error, *plain.coefficients[1].standard_error, 1e-10);
  const GlmmProfile profile = glmm_profile(input_of(all, "y ~ x + (1 | day)"));
  EXPECT_EQ(profile.sds[0].value().low, 0.0);
  EXPECT_GT(profile.sds[0].value().high, 0.0);
}

TEST(Glmm, SeparationIsAnErrorWithItsColumn) {
  std::vector<Trial> complete = trials(8, 8, 0.5, 5);
  for (Trial& trial : complete) {
    trial.y = trial.x > 0.1 ? 1 : 0;
  }
  const GlmmFit fit = fit_of(complete, "y ~ x + (1 | day)");
  expect_no_estimate(fit);
  EXPECT_EQ(condition(fit, ConditionKind::complete_separation).column, "(Intercept)");
  std::vector<Trial> quasi = trials(8, 9, 0.5, 6);
  for (Trial& trial : quasi) {
    trial.y = trial.run == 2 ? 1 : trial.y;
  }
  const GlmmFit other = fit_of(quasi, "y ~ x + run + (1 | day)");
  expect_no_estimate(other);
  EXPECT_EQ(condition(other, ConditionKind::quasi_separation).column, "runr2");
  EXPECT_NE(condition(other, ConditionKind::quasi_separation).detail.find("run = r2"),
            std::string::npos);
}

TEST(Glmm, RunawayVarianceIsNamed) {
  // Each day has one outcome, and x says little.
  std::vector<Trial> all = trials(12, 10, 0.0, 7);
  for (Trial& trial : all) {
    trial.y = trial.day % 2;
  }
  const GlmmFit fit = fit_of(all, "y ~ x + (1 | day)");
  expect_no_estimate(fit);
  EXPECT_EQ(condition(fit, ConditionKind::infinite_variance).column, "day");
}

TEST(Glmm, UselessGroupsAreNamed) {
  std::vector<Trial> all = trials(10, 6, 0.5, 8);
  EXPECT_EQ(condition(fit_of(all, "y ~ x"), ConditionKind::no_random_effects).severity,
            ConditionSeverity::error);
  for (Trial& trial : all) {
    trial.day = 3;
  }
  const GlmmFit one = fit_of(all, "y ~ x + (1 | day)");
  expect_no_estimate(one);
  EXPECT_EQ(condition(one, ConditionKind::one_group).column, "day");
  EXPECT_EQ(condition(one, ConditionKind::one_group).detail, "every row has d3");
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].day = static_cast<int>(k);
  }
  const GlmmFit single = fit_of(all, "y ~ x + (1 | day)");
  EXPECT_EQ(condition(single, ConditionKind::singleton_groups).severity,
            ConditionSeverity::warning);
  EXPECT_EQ(condition(single, ConditionKind::singleton_groups).detail, "60 levels, 60 rows");
}

TEST(Glmm, UselessColumnsAreNamed) {
  const std::vector<Trial> all = trials(10, 9, 0.8, 9);
  const GlmmFit fit = fit_of(all, "y ~ x + seven + twice + (1 | day)");
  EXPECT_EQ(condition(fit, ConditionKind::constant_column).column, "seven");
  EXPECT_EQ(condition(fit, ConditionKind::collinear_column).column, "twice");
  EXPECT_FALSE(fit.coefficients[2].estimate.has_value());
  EXPECT_NEAR(*fit.coefficients[1].estimate,
              *fit_of(all, "y ~ x + (1 | day)").coefficients[1].estimate,
              1e-9);
  const GlmmFit random = fit_of(all, "y ~ x + (1 + seven | day)");
  expect_no_estimate(random);
  EXPECT_EQ(condition(random, ConditionKind::collinear_column).column, "seven");
  const GlmmFit twice = fit_of(all, "y ~ x + (1 | day) + (1 | day)");
  expect_no_estimate(twice);
  EXPECT_EQ(condition(twice, ConditionKind::collinear_column).detail,
            "twice among the random effects of day");
}

TEST(Glmm, OneClassAndNoRowsAreNamed) {
  std::vector<Trial> all = trials(6, 5, 0.5, 10);
  for (Trial& trial : all) {
    trial.y = 1;
  }
  const GlmmFit fit = fit_of(all, "y ~ x + (1 | day)");
  expect_no_estimate(fit);
  EXPECT_EQ(condition(fit, ConditionKind::one_class).column, "y");
  all.resize(2);
  all[0].y = 0;
  EXPECT_TRUE(has_error(fit_of(all, "y ~ x + (1 | day)").conditions));
}

TEST(Glmm, NoConvergenceLeavesNoEstimate) {
  GlmmOptions options;
  options.max_iterations = 0;
  const GlmmFit fit = fit_of(trials(12, 12, 1.0, 11), "y ~ x + (1 | day)", options);
  expect_no_estimate(fit);
  EXPECT_EQ(fit.termination, GlmmTermination::iteration_limit);
  EXPECT_EQ(condition(fit, ConditionKind::not_converged).severity, ConditionSeverity::error);
}

TEST(Glmm, MisuseThrows) {
  const GlmmInput input = input_of(trials(6, 6, 0.5, 12), "y ~ x + (1 | day)");
  GlmmOptions options;
  for (const int quadrature : {0, 101, -3}) {
    options.quadrature = quadrature;
    EXPECT_THROW(static_cast<void>(fit_glmm(input, options)), std::invalid_argument);
  }
  options = {};
  options.level = 1.0;
  EXPECT_THROW(static_cast<void>(fit_glmm(input, options)), std::invalid_argument);
  GlmmInput bad = input;
  bad.random[0].design.conservativeResize(3, 1);
  EXPECT_THROW(static_cast<void>(fit_glmm(bad)), std::invalid_argument);
  const GlmmFit fit = fit_glmm(input);
  EXPECT_THROW(static_cast<void>(compare_models(fit, fit)), std::invalid_argument);
}

TEST(Glmm, ProfilesOfTwoTermsHoldTheirEstimates) {
  const GlmmInput input = input_of(trials(15, 12, 1.0, 13), "y ~ x + (1 | day) + (1 | run:day)");
  const GlmmFit fit = fit_glmm(input);
  const GlmmProfile profile = glmm_profile(input);
  for (std::size_t k = 0; k < 2; ++k) {
    const Interval interval = profile.coefficients[k].value();
    EXPECT_LT(interval.low, *fit.coefficients[k].estimate);
    EXPECT_GT(interval.high, *fit.coefficients[k].estimate);
    EXPECT_LE(profile.sds[k].value().low, fit.random[k].sd[0]);
    EXPECT_GT(profile.sds[k].value().high, fit.random[k].sd[0]);
  }
}

}  // namespace
}  // namespace tcert::statistics
