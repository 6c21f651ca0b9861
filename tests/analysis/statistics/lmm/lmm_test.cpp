#include <statistics/lmm/lmm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <statistics/glmm/glmm_problem.hpp>
#include <statistics/lmm/lmm_likelihood.hpp>
#include <statistics/logistic/orthonormal_basis.hpp>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

table::Factor factor_of(std::vector<std::uint32_t> codes, std::uint32_t levels) {
  table::Factor factor{std::move(codes), {}};
  for (std::uint32_t k = 0; k < levels; ++k) {
    factor.levels.push_back("g" + std::to_string(k));
  }
  return factor;
}

/// Groups of `size` rows, each with its own effect; x is of rows.
LmmInput grouped(std::uint32_t groups, std::size_t size, double between, std::uint64_t seed) {
  table::RandomStream random(seed, 1, 0);
  const auto rows = static_cast<Eigen::Index>(groups * size);
  LmmInput input;
  input.design = Eigen::MatrixXd::Ones(rows, 2);
  input.columns = {"(Intercept)", "x"};
  input.y.resize(rows);
  std::vector<std::uint32_t> codes;
  for (std::uint32_t g = 0; g < groups; ++g) {
    const double effect = between * random.normal();
    for (std::size_t i = 0; i < size; ++i) {
      const auto row = static_cast<Eigen::Index>(codes.size());
      input.design(row, 1) = random.normal();
      input.y[row] = 3.0 + 0.5 * input.design(row, 1) + effect + random.normal();
      codes.push_back(g);
    }
  }
  input.random = {
      {"g", factor_of(std::move(codes), groups), Eigen::MatrixXd::Ones(rows, 1), {"(Intercept)"}}};
  return input;
}

TEST(LinearMixedModel, ABalancedOneWayLayoutIsItsAnalysisOfVariance) {
  constexpr std::uint32_t kGroups = 8;
  constexpr std::size_t kSize = 5;
  LmmInput input = grouped(kGroups, kSize, 1.0, 3);
  input.design = Eigen::MatrixXd(input.design.leftCols(1));
  input.columns.pop_back();
  double between = 0.0;
  double within = 0.0;
  for (std::uint32_t g = 0; g < kGroups; ++g) {
    const auto own = input.y.segment(static_cast<Eigen::Index>(g * kSize), kSize).array();
    between += kSize * std::pow(own.mean() - input.y.mean(), 2) / (kGroups - 1.0);
    within += (own - own.mean()).square().sum() / (kGroups * (kSize - 1.0));
  }
  const LmmFit fit = fit_lmm(input);
  EXPECT_EQ(fit.termination, GlmmTermination::converged);
  EXPECT_NEAR(fit.residual_sd, std::sqrt(within), 1e-8);
  EXPECT_NEAR(fit.random[0].sd[0], std::sqrt((between - within) / kSize), 1e-7);
  EXPECT_NEAR(*fit.coefficients[0].estimate, input.y.mean(), 1e-12);
  EXPECT_NEAR(*fit.coefficients[0].standard_error, std::sqrt(between / (kGroups * kSize)), 1e-8);
  EXPECT_NEAR(*fit.coefficients[0].df, kGroups - 1.0, 1e-4) << "the mean of groups alone";
  EXPECT_EQ(*fit.r2_marginal, 0.0);
  EXPECT_NEAR(*fit.r2_conditional, *fit.icc, 1e-12);
}

TEST(LinearMixedModel, TheGradientIsThatOfTheCriterion) {
  LmmInput input = grouped(6, 7, 0.7, 5);
  std::vector<std::uint32_t> other;
  for (std::uint32_t i = 0; i < 42; ++i) {
    other.push_back((i * 5 + i / 9) % 4);
  }
  input.random[0].columns = {"(Intercept)", "x"};
  input.random[0].design = input.design;
  input.random.push_back({"h", factor_of(other, 4), Eigen::MatrixXd::Ones(42, 1), {"(Intercept)"}});
  std::vector<Eigen::Index> rows(42);
  std::iota(rows.begin(), rows.end(), 0);
  std::vector<TermRows> terms;
  for (const RandomEffects& random : input.random) {
    terms.push_back(term_rows(random, rows, true));
  }
  const OrthonormalBasis space = orthonormal_basis(input.design);
  for (const bool restricted : {true, false}) {
    LmmLikelihood likelihood(space.basis, input.y, terms, {}, restricted);
    const Eigen::VectorXd at = Eigen::Vector4d(0.8, -0.3, 0.5, 0.4);
    LikelihoodPoint point;
    ASSERT_TRUE(likelihood.evaluate(at, Derivatives::gradient, point));
    for (Eigen::Index j = 0; j < at.size(); ++j) {
      const double step = 1e-5;
      LikelihoodPoint up;
      LikelihoodPoint down;
      ASSERT_TRUE(
          likelihood.evaluate(at + step * Eigen::VectorXd::Unit(4, j), Derivatives::none, up));
      ASSERT_TRUE(
          likelihood.evaluate(at - step * Eigen::VectorXd::Unit(4, j), Derivatives::none, down));
      EXPECT_NEAR(point.gradient[j], (up.value - down.value) / (2.0 * step), 1e-7);
    }
  }
}

TEST(LinearMixedModel, WithoutSpreadBetweenGroupsTheFitIsSingularAndOrdinary) {
  LmmInput input = grouped(10, 6, 0.0, 11);
  // Groups of equal means: less spread than rows alone would give.
  for (Eigen::Index g = 0; g < 10; ++g) {
    input.y.segment(6 * g, 6).array() -= input.y.segment(6 * g, 6).mean();
    input.design.col(1).segment(6 * g, 6).array() -= input.design.col(1).segment(6 * g, 6).mean();
  }
  const LmmFit fit = fit_lmm(input);
  EXPECT_TRUE(fit.singular);
  EXPECT_EQ(fit.random[0].sd[0], 0.0);
  EXPECT_TRUE(has(fit.conditions, ConditionKind::singular_fit));
  const Eigen::VectorXd x = input.design.col(1);
  EXPECT_NEAR(*fit.coefficients[1].estimate, x.dot(input.y) / x.squaredNorm(), 1e-12);
  EXPECT_NEAR(*fit.coefficients[1].df, 58.0, 1e-6) << "rows less coefficients";
  EXPECT_EQ(fit.random[0].test->p_value, 1.0);
}

TEST(LinearMixedModel, SharesOfVarianceDoNotDependOnUnits) {
  LmmInput input = grouped(9, 8, 0.6, 2);
  const LmmFit before = fit_lmm(input);
  input.y = (100.0 * input.y.array() + 7.0).matrix();
  input.design.col(1) *= 1e-4;
  const LmmFit after = fit_lmm(input);
  EXPECT_NEAR(*after.r2_marginal, *before.r2_marginal, 1e-9);
  EXPECT_NEAR(*after.r2_conditional, *before.r2_conditional, 1e-9);
  EXPECT_NEAR(*after.coefficients[1].t, *before.coefficients[1].t, 1e-7);
  EXPECT_GT(*before.r2_marginal, 0.0);
  EXPECT_LT(*before.r2_marginal, *before.r2_conditional);
  EXPECT_LT(*before.r2_conditional, 1.0);
}

TEST(LinearMixedModel, NamesWhatLeavesNoEstimate) {
  const auto first_error = [](const LmmInput& input) {
    const LmmFit fit = fit_lmm(input);
    EXPECT_FALSE(fit.log_likelihood);
    for (const Condition& condition : fit.conditions) {
      if (condition.severity == ConditionSeverity::error) {
        return condition.kind;
      }
    }
    return ConditionKind::no_rows;
  };
  LmmInput none = grouped(5, 4, 1.0, 1);
  none.random.clear();
  EXPECT_EQ(first_error(none), ConditionKind::no_random_effects);
  LmmInput one = grouped(1, 20, 1.0, 1);
  EXPECT_EQ(first_error(one), ConditionKind::one_group);
  EXPECT_EQ(first_error(grouped(20, 1, 1.0, 1)), ConditionKind::singleton_groups);
  LmmInput constant = grouped(5, 4, 1.0, 1);
  constant.y.setConstant(2.0);
  EXPECT_EQ(first_error(constant), ConditionKind::constant_column);
  LmmInput twice = grouped(5, 4, 1.0, 1);
  twice.design.conservativeResize(Eigen::NoChange, 3);
  twice.design.col(2) = 2.0 * twice.design.col(1);
  twice.columns.emplace_back("twice");
  const LmmFit fit = fit_lmm(twice);
  EXPECT_TRUE(has(fit.conditions, ConditionKind::collinear_column));
  EXPECT_EQ(fit.coefficients[2].kind, CoefficientKind::not_estimable);
  EXPECT_TRUE(fit.coefficients[1].p_value);
}

}  // namespace
}  // namespace tcert::statistics
