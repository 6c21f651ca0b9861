// Every logistic case of R's glm goldens, through formula and model frame.

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_drop.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <string>

#include "support/data_table.hpp"
#include "support/temporary_folder.hpp"

namespace tcert::statistics {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kRelative = 1e-9;

/// R's own iteration (`glm.fit`, McCullagh and Nelder 1989): the covariance that it reports belongs
/// to the coefficients before the last step, which at its tightest control still moves standard
/// errors by 1e-7.
struct RFit {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
};

RFit r_irls(const LogisticInput& input, const Eigen::MatrixXd& X, int iterations) {
  const Eigen::Index n = X.rows();
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(n);
  const Eigen::VectorXd trials = input.trials.size() > 0 ? input.trials : ones;
  const Eigen::VectorXd weight = input.weights.size() > 0 ? input.weights : ones;
  const Eigen::VectorXd offset = input.offset.size() > 0 ? input.offset : 0.0 * ones;
  const Eigen::ArrayXd y = input.successes.array() / trials.array();
  const Eigen::ArrayXd w = weight.array() * trials.array();
  Eigen::ArrayXd mu = (w * y + 0.5) / (w + 1.0);
  Eigen::ArrayXd eta = (mu / (1.0 - mu)).log();
  RFit fit;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Eigen::ArrayXd variance = mu * (1.0 - mu);
    const Eigen::ArrayXd z = eta - offset.array() + (y - mu) / variance;
    const Eigen::MatrixXd half = (w * variance).sqrt().matrix().asDiagonal() * X;
    // As glm.fit: columns are scaled, so that their units do not matter to the inverse.
    const Eigen::VectorXd scale = half.colwise().norm().cwiseInverse().transpose();
    const Eigen::MatrixXd scaled = half * scale.asDiagonal();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
    fit.coefficients =
        scale.asDiagonal() * Eigen::VectorXd(qr.solve(((w * variance).sqrt() * z).matrix()));
    const Eigen::MatrixXd r = qr.matrixQR().topRows(X.cols()).triangularView<Eigen::Upper>();
    const Eigen::MatrixXd inverse =
        r.triangularView<Eigen::Upper>().solve(Eigen::MatrixXd::Identity(X.cols(), X.cols()));
    fit.covariance = scale.asDiagonal() * inverse * inverse.transpose() * scale.asDiagonal();
    eta = (X * fit.coefficients).array() + offset.array();
    mu = 1.0 / (1.0 + (-eta).exp());
  }
  return fit;
}

/// The worst relative disagreement per quantity.
std::map<std::string, double>& worst() {
  static std::map<std::string, double> table;
  return table;
}

void expect_equal(const std::string& quantity,
                  double actual,
                  double expected,
                  double relative = kRelative) {
  const double error = std::abs(actual - expected) / std::max(std::abs(expected), 1e-300);
  worst()[quantity] = std::max(worst()[quantity], error);
  EXPECT_LE(error, relative) << quantity << ": " << actual << " is not " << expected;
}

bool is_number(const json& value) { return value.is_number(); }

class LogisticGolden : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test_support::shared_data() / "stats";
    std::ifstream file(folder_ / "golden" / "glm.json");
    if (!file) {
      GTEST_SKIP() << "no golden values: " << (folder_ / "golden" / "glm.json");
    }
    golden_ = json::parse(file)["models"];
  }

  [[nodiscard]] LogisticInput input_of(const json& expected) const {
    FrameOptions options;
    if (expected["weights"].is_string() && expected["weights"] != "NA") {
      options.weights = expected["weights"].get<std::string>();
    }
    return logistic_input(
        test_support::frame_of_file(folder_ / "data" / expected["data"].get<std::string>(),
                                    expected["f"].get<std::string>(),
                                    options));
  }

  fs::path folder_;
  json golden_;
};

bool separated(const std::string& name) { return name.starts_with("sep_") || name == "oneclass"; }

void compare_coefficients(const LogisticInput& input,
                          const LogisticFit& fit,
                          const json& expected) {
  std::vector<Eigen::Index> kept;
  for (std::size_t j = 0; j < fit.coefficients.size(); ++j) {
    const LogisticCoefficient& coefficient = fit.coefficients[j];
    ASSERT_TRUE(expected["coef"].contains(coefficient.column)) << coefficient.column;
    const json& value = expected["coef"][coefficient.column];
    ASSERT_EQ(coefficient.estimate.has_value(), is_number(value)) << coefficient.column;
    if (coefficient.estimate) {
      kept.push_back(static_cast<Eigen::Index>(j));
      expect_equal("coef", *coefficient.estimate, value.get<double>());
    }
  }
  const Eigen::MatrixXd X = input.design(Eigen::all, kept);
  const RFit as_r = r_irls(input, X, expected["iter"].get<int>());
  const RFit beyond = r_irls(input, X, expected["iter"].get<int>() + 3);
  const json& rows = expected["vcov"]["rows"];
  for (Eigen::Index a = 0; a < X.cols(); ++a) {
    const LogisticCoefficient& coefficient =
        fit.coefficients[static_cast<std::size_t>(kept[static_cast<std::size_t>(a)])];
    const std::string& name = coefficient.column;
    const double error = coefficient.standard_error.value();
    const double r_error = std::sqrt(as_r.covariance(a, a));
    const double r_z = as_r.coefficients[a] / r_error;
    expect_equal("R's se, recomputed", r_error, expected["se"][name].get<double>());
    expect_equal("R's z, recomputed", r_z, expected["z"][name].get<double>());
    expect_equal("R's p, recomputed",
                 std::erfc(std::abs(r_z) / std::sqrt(2.0)),
                 expected["p"][name].get<double>(),
                 // d log p = z dz, and R's table has 15 digits of p.
                 kRelative * (1.0 + r_z * r_z));
    expect_equal("se, at R's limit", error, std::sqrt(beyond.covariance(a, a)));
    expect_equal("se, as R printed it", error, expected["se"][name].get<double>(), 2e-7);
    expect_equal("z, as R printed it", *coefficient.z, expected["z"][name].get<double>(), 2e-7);
    EXPECT_NEAR(*coefficient.z, *coefficient.estimate / error, 1e-15 * std::abs(*coefficient.z));
    EXPECT_EQ(*coefficient.p_value, std::erfc(std::abs(*coefficient.z) / std::sqrt(2.0)));
    for (Eigen::Index b = 0; b < X.cols(); ++b) {
      const auto at = [&](Eigen::Index k) {
        const std::string& wanted =
            fit.coefficients[static_cast<std::size_t>(kept[static_cast<std::size_t>(k)])].column;
        return static_cast<std::size_t>(
            std::distance(rows.begin(), std::find(rows.begin(), rows.end(), wanted)));
      };
      const double scale = std::sqrt(beyond.covariance(a, a) * beyond.covariance(b, b));
      const double mine =
          fit.covariance(kept[static_cast<std::size_t>(a)], kept[static_cast<std::size_t>(b)]);
      const double golden = expected["vcov"]["values"][at(a)][at(b)].get<double>();
      expect_equal("2 + vcov / scale, R's recomputed",
                   2.0 + as_r.covariance(a, b) / scale,
                   2.0 + golden / scale);
      expect_equal("2 + vcov / scale, at R's limit",
                   2.0 + mine / scale,
                   2.0 + beyond.covariance(a, b) / scale);
    }
  }
}

TEST_F(LogisticGolden, FitsEqualGlm) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_.items()) {
    if (separated(name)) {
      continue;
    }
    SCOPED_TRACE(name);
    const LogisticInput input = input_of(expected);
    const LogisticFit fit = fit_logistic(input);
    ASSERT_FALSE(has_error(fit.conditions));
    EXPECT_EQ(fit.separation, Separation::none);
    EXPECT_EQ(fit.termination, Termination::converged);
    compare_coefficients(input, fit, expected);
    expect_equal("logLik", fit.log_likelihood.value(), expected["logLik"]);
    expect_equal("deviance", fit.deviance.value(), expected["deviance"]);
    expect_equal("null deviance", fit.null_deviance.value(), expected["null_deviance"]);
    expect_equal("AIC", fit.aic.value(), expected["AIC"]);
    expect_equal("BIC", fit.bic.value(), expected["BIC"]);
    EXPECT_EQ(fit.df_residual, expected["df_residual"].get<std::size_t>());
    for (std::size_t i = 0; i < expected["fitted_first"].size(); ++i) {
      expect_equal("fitted", fit.fitted[static_cast<Eigen::Index>(i)], expected["fitted_first"][i]);
    }
    ++cases;
  }
  std::printf("glm golden cases run: %zu fits\n", cases);
  EXPECT_GT(cases, 0U);
}

constexpr double kChiSquared = 3.841458820694124;  // 95 %, one degree of freedom

/// Least deviance with coefficient `column` held at `value`: refitted without it.
double deviance_with(const LogisticInput& input, std::size_t column, double value) {
  LogisticInput rest = input;
  std::vector<Eigen::Index> others;
  rest.columns.clear();
  rest.term_of.clear();
  for (std::size_t j = 0; j < input.columns.size(); ++j) {
    if (j != column) {
      others.push_back(static_cast<Eigen::Index>(j));
      rest.columns.push_back(input.columns[j]);
      rest.term_of.push_back(input.term_of[j]);
    }
  }
  rest.design = input.design(Eigen::all, others);
  const Eigen::VectorXd shift = value * input.design.col(static_cast<Eigen::Index>(column));
  rest.offset = input.offset.size() > 0 ? Eigen::VectorXd(input.offset + shift) : shift;
  return fit_logistic(rest).deviance.value();
}

TEST_F(LogisticGolden, ProfileIntervalsAreRootsNearThoseOfMass) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_.items()) {
    if (!expected.contains("profile95")) {
      continue;
    }
    SCOPED_TRACE(name);
    const LogisticInput input = input_of(expected);
    const auto intervals = profile_intervals(input);
    const json& rows = expected["profile95"]["rows"];
    for (std::size_t j = 0; j < input.columns.size(); ++j) {
      ASSERT_EQ(rows[j], input.columns[j]);
      ASSERT_TRUE(intervals[j].has_value());
      const json& ends = expected["profile95"]["values"][j];
      // MASS reads its ends off a spline through points about z / 5 apart: measured here, that is
      // off by up to 1.6e-4 of the interval's width, so the roots are checked by themselves.
      const double width = ends[1].get<double>() - ends[0].get<double>();
      for (const auto& [mine, golden] : {std::pair{intervals[j]->low, ends[0].get<double>()},
                                         {intervals[j]->high, ends[1].get<double>()}}) {
        expect_equal("1 + profile / width", 1.0 + (mine - golden) / width, 1.0, 2e-4);
        const double drop = deviance_with(input, j, mine) - *fit_logistic(input).deviance;
        expect_equal("profile's drop of deviance", drop, kChiSquared, 1e-9);
      }
    }
    ++cases;
  }
  std::printf("glm golden cases run: %zu profiles\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(LogisticGolden, TestsOfTermsEqualDrop1) {
  std::size_t cases = 0;
  for (const auto& [name, expected] : golden_.items()) {
    if (!expected.contains("drop1_LRT")) {
      continue;
    }
    SCOPED_TRACE(name);
    const std::vector<DroppedTerm> terms = drop_terms(input_of(expected));
    const json& drop = expected["drop1_LRT"];
    ASSERT_EQ(terms.size() + 1, drop["terms"].size());
    for (std::size_t k = 0; k < terms.size(); ++k) {
      EXPECT_EQ(terms[k].term, drop["terms"][k + 1]);
      EXPECT_EQ(terms[k].df, drop["df"][k + 1].get<std::size_t>());
      expect_equal("drop1 deviance", terms[k].deviance.value(), drop["deviance"][k + 1]);
      // A difference of deviances carries the rounding of deviances.
      EXPECT_NEAR(terms[k].chi_squared.value(),
                  drop["LRT"][k + 1].get<double>(),
                  1e-13 * terms[k].deviance.value() + 1e-9 * drop["LRT"][k + 1].get<double>());
      expect_equal("drop1 p", terms[k].p_value.value(), drop["p"][k + 1]);
    }
    ++cases;
  }
  std::printf("glm golden cases run: %zu tables of dropped terms\n", cases);
  EXPECT_GT(cases, 0U);
}

TEST_F(LogisticGolden, SeparationIsNamedWhereGlmIsSilent) {
  const LogisticFit complete = fit_logistic(input_of(golden_["sep_complete"]));
  EXPECT_EQ(complete.separation, Separation::complete);
  EXPECT_EQ(complete.coefficients[1].kind, CoefficientKind::plus_infinity);
  EXPECT_FALSE(complete.coefficients[1].estimate.has_value());
  EXPECT_TRUE(has(complete.conditions, ConditionKind::complete_separation));
  EXPECT_TRUE(has_error(complete.conditions));

  const LogisticFit both = fit_logistic(input_of(golden_["sep_complete_z"]));
  EXPECT_EQ(both.separation, Separation::complete);
  EXPECT_EQ(both.coefficients[1].kind, CoefficientKind::plus_infinity);
  EXPECT_EQ(both.coefficients[2].kind, CoefficientKind::diverging);

  const json& golden = golden_["sep_quasi"];
  const LogisticFit quasi = fit_logistic(input_of(golden));
  EXPECT_EQ(quasi.separation, Separation::quasi);
  ASSERT_EQ(quasi.conditions.size(), 1U);
  EXPECT_EQ(quasi.conditions[0].kind, ConditionKind::quasi_separation);
  EXPECT_EQ(quasi.conditions[0].column, "fc");
  EXPECT_EQ(quasi.conditions[0].detail,
            "the estimate is +infinity, every row with f = c has y = 1");
  for (const LogisticCoefficient& coefficient : quasi.coefficients) {
    if (coefficient.column == "fc") {
      EXPECT_EQ(coefficient.kind, CoefficientKind::plus_infinity);
      continue;
    }
    // These stay finite; R's, stopped on the way, agree as far as it has come.
    EXPECT_NEAR(*coefficient.estimate, golden["coef"][coefficient.column].get<double>(), 1e-6);
    EXPECT_NEAR(*coefficient.standard_error, golden["se"][coefficient.column].get<double>(), 1e-6);
  }
  EXPECT_NEAR(quasi.deviance.value(), golden["deviance"].get<double>(), 1e-6);

  const LogisticFit one = fit_logistic(input_of(golden_["oneclass"]));
  EXPECT_TRUE(has(one.conditions, ConditionKind::one_class));
  EXPECT_FALSE(one.coefficients[0].estimate.has_value());
}

/// Last, so that it sees what the others have compared.
TEST_F(LogisticGolden, ZWorstDisagreement) {
  for (const auto& [quantity, error] : worst()) {
    std::printf("  %-36s %.1e\n", quantity.c_str(), error);
  }
}

}  // namespace
}  // namespace tcert::statistics
