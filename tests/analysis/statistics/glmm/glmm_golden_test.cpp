// Every mixed model of R's goldens, through formula and model frame: to 1e-7 of the independent
// reference optima, and to what lme4's own optimisers reach where there is no reference.

#include <gtest/gtest.h>

#include <statistics/glmm/glmm.hpp>
#include <statistics/glmm/glmm_comparison.hpp>
#include <statistics/glmm/glmm_profile.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include "analysis/statistics/glmm/glmm_golden.hpp"

#include "support/temporary_folder.hpp"

namespace tcert::statistics {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kReference = 1e-7;  // relative, of the reference optima
constexpr double kLme4 = 2e-5;       // of lme4's fields: its optimisers stop there
constexpr double kLme4Error = 5e-4;  // of its SEs: their Hessian is made of differences
constexpr double kExtra = 1e-4;      // of fields without a reference

/// The worst relative disagreement per quantity.
std::map<std::string, double>& worst() {
  static std::map<std::string, double> table;
  return table;
}

void expect_within(const std::string& quantity, double gap, double tolerance, double expected) {
  worst()[quantity] = std::max(worst()[quantity], gap);
  EXPECT_LE(gap, tolerance) << quantity << " of " << expected;
}

void expect_equal(const std::string& quantity, double actual, double expected, double tolerance) {
  expect_within(quantity, std::abs(actual - expected) / std::abs(expected), tolerance, expected);
}

/// Relative, but 0 is met to within the tolerance itself.
void expect_near(const std::string& quantity, double actual, double expected, double tolerance) {
  expect_within(quantity,
                std::abs(actual - expected) / std::max(1.0, std::abs(expected)),
                tolerance,
                expected);
}

const LogisticCoefficient& coefficient(const GlmmFit& fit, const std::string& name) {
  return *std::find_if(fit.coefficients.begin(),
                       fit.coefficients.end(),
                       [&](const LogisticCoefficient& one) { return one.column == name; });
}

class GlmmGolden : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test_support::shared_data() / "stats";
    std::ifstream file(folder_ / "golden" / "glmer.json");
    std::ifstream extra(folder_ / "golden" / "glmer_extra.json");
    if (!file || !extra) {
      GTEST_SKIP() << "no golden values: " << (folder_ / "golden" / "glmer.json");
    }
    golden_ = json::parse(file)["models"];
    extra_ = json::parse(extra)["models"];
  }

  fs::path folder_;
  json golden_;
  json extra_;
};

void compare_with_reference(const GlmmFit& fit, const json& reference) {
  expect_equal("reference logLik", fit.log_likelihood.value(), reference["logLik"], kReference);
  for (const auto& [name, value] : reference["fixef"].items()) {
    const LogisticCoefficient& one = coefficient(fit, name);
    // The reference stops at a gradient, which is up to 1e-7: that far it may be off itself.
    const double stopped = reference.value("max_abs_gradient", 0.0) * *one.standard_error *
                           *one.standard_error / std::abs(value.get<double>());
    expect_equal("reference fixef", one.estimate.value(), value, kReference + stopped);
  }
  if (reference["theta"] == 0.0) {
    EXPECT_TRUE(fit.singular);
    EXPECT_EQ(fit.random[0].sd[0], 0.0);
    EXPECT_TRUE(has(fit.conditions, ConditionKind::singular_fit));
    EXPECT_EQ(fit.random[0].test.value().p_value, 1.0);
    return;
  }
  EXPECT_FALSE(fit.singular);
  expect_equal("reference theta", fit.random[0].sd[0], reference["theta"], kReference);
  for (const auto& [name, value] : reference["se"].items()) {
    expect_equal("reference se", coefficient(fit, name).standard_error.value(), value, kReference);
  }
  if (reference.contains("lrt_vs_glm")) {
    const BoundaryTest& test = fit.random[0].test.value();
    EXPECT_NEAR(test.chi_squared, reference["lrt_vs_glm"]["chisq"].get<double>(), 1e-7);
    expect_equal("boundary p", test.p_value, reference["lrt_vs_glm"]["p_half_chibar"], 1e-6);
  }
  if (reference.contains("cond_modes_first")) {
    for (const auto& [level, value] : reference["cond_modes_first"].items()) {
      const auto& levels = fit.random[0].levels;
      const auto at = std::distance(levels.begin(), std::find(levels.begin(), levels.end(), level));
      expect_near("reference mode", fit.random[0].modes(at, 0), value, kReference);
      expect_equal("reference mode sd",
                   fit.random[0].mode_sds(at, 0),
                   reference["cond_sd_first"][level],
                   kReference);
    }
  }
}

void compare_with_lme4(const GlmmFit& fit, const json& golden, int quadrature) {
  for (const auto& [name, value] : golden["fixef"].items()) {
    expect_near("lme4 fixef", coefficient(fit, name).estimate.value(), value, kLme4);
    expect_equal(
        "lme4 se", coefficient(fit, name).standard_error.value(), golden["se"][name], kLme4Error);
  }
  expect_near("lme4 theta", fit.random[0].sd[0], golden["theta"], kLme4);
  EXPECT_EQ(fit.parameters, golden["npar"].get<std::size_t>());
  EXPECT_EQ(fit.rows, golden["nobs"].get<std::size_t>());
  EXPECT_EQ(fit.singular, golden["singular"].get<bool>());
  EXPECT_EQ(fit.random[0].levels.size(), golden["ngroups"].get<std::size_t>());
  expect_near("lme4 sum of modes", fit.random[0].modes.sum(), golden["cond_modes_sum"], kLme4);
  expect_near("lme4 sum of squared modes",
              fit.random[0].modes.squaredNorm(),
              golden["cond_modes_sumsq"],
              kLme4);
  if (quadrature == 1) {
    expect_near("lme4 logLik", fit.log_likelihood.value(), golden["logLik"], kLme4);
    expect_near("lme4 AIC", fit.aic.value(), golden["AIC"], kLme4);
    expect_near("lme4 BIC", fit.bic.value(), golden["BIC"], kLme4);
  }
}

TEST_F(GlmmGolden, SingleInterceptsEqualTheReferences) {
  std::size_t cases = 0;
  for (const auto& [name, model] : golden_.items()) {
    const GlmmInput input = golden_input(folder_ / "data", model);
    for (const auto& [key, golden] : model["fits"].items()) {
      SCOPED_TRACE(name + " " + key);
      GlmmOptions options;
      options.quadrature = std::stoi(key.substr(4));
      const GlmmFit fit = fit_glmm(input, options);
      ASSERT_FALSE(has_error(fit.conditions)) << to_string(fit.conditions.back());
      EXPECT_EQ(fit.termination, GlmmTermination::converged);
      EXPECT_LT(fit.gradient_norm, 1e-8);
      compare_with_reference(fit, golden["reference"]);
      compare_with_lme4(fit, golden, *options.quadrature);
      ++cases;
    }
  }
  std::printf("glmer golden cases run: %zu fits of a single intercept\n", cases);
  EXPECT_GT(cases, 0U);
}

const GlmmRandomTerm& term_of(const GlmmFit& fit, const json& part) {
  std::string group = part["grp"];
  const bool second = group.ends_with(".1");
  group = second ? group.substr(0, group.size() - 2) : group;
  return *std::find_if(fit.random.begin(), fit.random.end(), [&](const GlmmRandomTerm& term) {
    const auto& names = term.columns;
    return term.group == group &&
           std::find(names.begin(), names.end(), part["var1"]) != names.end();
  });
}

void compare_variances(const GlmmFit& fit, const json& golden) {
  for (const json& part : golden["varcor"]) {
    const GlmmRandomTerm& term = term_of(fit, part);
    const auto place = [&](const json& name) {
      return static_cast<Eigen::Index>(std::distance(
          term.columns.begin(), std::find(term.columns.begin(), term.columns.end(), name)));
    };
    const Eigen::Index a = place(part["var1"]);
    if (part["var2"].is_string()) {
      expect_near(
          "extra correlation", term.correlation(a, place(part["var2"])), part["sdcor"], kExtra);
    } else {
      expect_near("extra sd", term.sd[static_cast<std::size_t>(a)], part["sdcor"], kExtra);
    }
  }
}

void compare_modes(const GlmmFit& fit, const json& golden) {
  for (const auto& [group, first] : golden["ranef_first"].items()) {
    for (std::size_t row = 0; row < first["rows"].size(); ++row) {
      const json columns = first["cols"].is_string() ? json::array({first["cols"]}) : first["cols"];
      for (std::size_t column = 0; column < columns.size(); ++column) {
        const GlmmRandomTerm& term = term_of(fit, {{"grp", group}, {"var1", columns[column]}});
        const auto level = std::find(term.levels.begin(), term.levels.end(), first["rows"][row]);
        const auto name = std::find(term.columns.begin(), term.columns.end(), columns[column]);
        ASSERT_NE(level, term.levels.end());
        expect_near("extra modes",
                    term.modes(std::distance(term.levels.begin(), level),
                               std::distance(term.columns.begin(), name)),
                    first["values"][row][column],
                    kExtra);
      }
    }
  }
}

TEST_F(GlmmGolden, OtherModelsEqualGlmer) {
  std::size_t cases = 0;
  for (const auto& [name, golden] : extra_.items()) {
    if (!golden.contains("varcor")) {
      continue;
    }
    SCOPED_TRACE(name);
    GlmmOptions options;
    options.quadrature = golden["nAGQ"].get<int>();
    const GlmmFit fit = fit_glmm(golden_input(folder_ / "data", golden), options);
    ASSERT_FALSE(has_error(fit.conditions)) << to_string(fit.conditions.back());
    EXPECT_EQ(fit.termination, GlmmTermination::converged);
    if (golden.contains("reference")) {
      compare_with_reference(fit, golden["reference"]);
    }
    for (const auto& [column, value] : golden["fixef"].items()) {
      expect_near("extra fixef", coefficient(fit, column).estimate.value(), value, kExtra);
      expect_equal("extra se",
                   coefficient(fit, column).standard_error.value(),
                   golden["se"][column],
                   kExtra);
    }
    compare_variances(fit, golden);
    compare_modes(fit, golden);
    expect_near("extra logLik", fit.log_likelihood.value(), golden["logLik"], kExtra);
    expect_near("extra AIC", fit.aic.value(), golden["AIC"], kExtra);
    expect_near("extra BIC", fit.bic.value(), golden["BIC"], kExtra);
    EXPECT_EQ(fit.parameters, golden["npar"].get<std::size_t>());
    EXPECT_EQ(fit.singular, golden["singular"].get<bool>());
    ++cases;
  }
  std::printf("glmer golden cases run: %zu other models\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(GlmmGolden, QuadratureOfTwoTermsIsRefused) {
  ASSERT_TRUE(extra_["nAGQ10_two_terms"].contains("error"));
  GlmmOptions options;
  options.quadrature = 10;
  EXPECT_THROW(static_cast<void>(
                   fit_glmm(golden_input(folder_ / "data", extra_["sim660_lightnested"]), options)),
               std::invalid_argument);
}

constexpr double kChiSquared = 3.841458820694124;  // 95 %, one degree of freedom

/// How far -2 log-likelihood rises with a coefficient held at `value`: refitted without it.
double rise_with(const GlmmInput& input, std::size_t column, double value, const GlmmOptions& how) {
  GlmmInput rest = input;
  std::vector<Eigen::Index> others;
  rest.fixed.columns.clear();
  rest.fixed.term_of.clear();
  for (std::size_t j = 0; j < input.fixed.columns.size(); ++j) {
    if (j != column) {
      others.push_back(static_cast<Eigen::Index>(j));
      rest.fixed.columns.push_back(input.fixed.columns[j]);
      rest.fixed.term_of.push_back(input.fixed.term_of[j]);
    }
  }
  rest.fixed.design = input.fixed.design(Eigen::all, others);
  rest.fixed.offset = value * input.fixed.design.col(static_cast<Eigen::Index>(column));
  return 2.0 *
         (fit_glmm(input, how).log_likelihood.value() - fit_glmm(rest, how).log_likelihood.value());
}

TEST_F(GlmmGolden, ProfileIntervalsEqualConfint) {
  const std::map<std::string, std::string> models{
      {"cbpp", "cbpp_counts"}, {"sim660", "sim660"}, {"bacteria", "bacteria"}};
  std::size_t cases = 0;
  for (const auto& [name, golden] : extra_.items()) {
    const auto cut = name.find("_confint_nAGQ");
    if (cut == std::string::npos) {
      continue;
    }
    SCOPED_TRACE(name);
    const std::string model = models.at(name.substr(0, cut));
    const GlmmInput input = golden_input(folder_ / "data", golden_[model]);
    GlmmOptions options;
    options.quadrature = std::stoi(name.substr(cut + 13));
    const GlmmProfile profile = glmm_profile(input, options);
    const GlmmFit fit = fit_glmm(input, options);
    const json& rows = golden["profile95"]["rows"];
    ASSERT_EQ(rows.size(), input.fixed.columns.size() + 1);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const json& ends = golden["profile95"]["values"][k];
      const Interval mine = k == 0 ? profile.sds[0].value() : profile.coefficients[k - 1].value();
      expect_near("profile low", mine.low, ends[0], 1e-3);
      expect_near("profile high", mine.high, ends[1], 1e-3);
      if (k == 0) {
        continue;
      }
      EXPECT_EQ(rows[k], input.fixed.columns[k - 1]);
      const Interval wald = fit.coefficients[k - 1].interval.value();
      expect_near("Wald low", wald.low, golden["wald95"]["values"][k][0], kLme4Error);
      expect_near("Wald high", wald.high, golden["wald95"]["values"][k][1], kLme4Error);
      for (const double end : {mine.low, mine.high}) {
        expect_equal(
            "profile's rise of deviance", rise_with(input, k - 1, end, options), kChiSquared, 1e-8);
      }
    }
    ++cases;
  }
  std::printf("glmer golden cases run: %zu tables of intervals\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(GlmmGolden, TestsOfTermsEqualDrop1AndAnova) {
  const GlmmInput input = golden_input(folder_ / "data", golden_["sim660"]);
  GlmmOptions laplace;
  laplace.quadrature = 1;
  const std::vector<DroppedTerm> terms = drop_terms(input, laplace);
  const json& drop = extra_["sim660_drop1"];
  ASSERT_EQ(terms.size() + 1, drop["terms"].size());
  for (std::size_t k = 0; k < terms.size(); ++k) {
    EXPECT_EQ(terms[k].term, drop["terms"][k + 1]);
    EXPECT_EQ(terms[k].df, drop["npar"][k + 1].get<std::size_t>());
    expect_near("drop1 AIC", terms[k].aic.value(), drop["AIC"][k + 1], 1e-8);
    expect_near("drop1 LRT", terms[k].chi_squared.value(), drop["LRT"][k + 1], 1e-6);
    expect_near("drop1 p", terms[k].p_value.value(), drop["p"][k + 1], 1e-6);
  }
  const json& anova = extra_["sim660_anova_lighting"];
  const GlmmInput small{without_term(input.fixed, 4), input.random};
  const ChiSquareTest test =
      compare_models(fit_glmm(small, laplace), fit_glmm(input, laplace)).value();
  expect_near("anova chi-squared", test.statistic, anova["chisq"], 1e-6);
  EXPECT_EQ(test.df, anova["df"].get<std::size_t>());
  expect_near("anova p", test.p_value, anova["p"], 1e-6);
}

/// Last, so that it sees what the others have compared.
TEST_F(GlmmGolden, ZWorstDisagreement) {
  for (const auto& [quantity, gap] : worst()) {
    std::printf("  %-28s %.1e\n", quantity.c_str(), gap);
  }
}

}  // namespace
}  // namespace tcert::statistics
