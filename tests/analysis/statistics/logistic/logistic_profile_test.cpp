#include <statistics/logistic/logistic_profile.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <statistics/basics/normal.hpp>
#include <string>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

/// Columns beside an intercept, each its own term.
LogisticInput input_of(const std::vector<std::vector<double>>& columns,
                       const std::vector<double>& y) {
  LogisticInput input;
  const auto n = static_cast<Eigen::Index>(y.size());
  input.design = Eigen::MatrixXd::Ones(n, static_cast<Eigen::Index>(columns.size()) + 1);
  input.columns = {"(Intercept)"};
  input.term_of = {0};
  for (std::size_t j = 0; j < columns.size(); ++j) {
    input.design.col(static_cast<Eigen::Index>(j) + 1) =
        Eigen::Map<const Eigen::VectorXd>(columns[j].data(), n);
    input.columns.push_back("x" + std::to_string(j));
    input.terms.push_back(input.columns.back());
    input.term_of.push_back(j + 1);
  }
  input.successes = Eigen::Map<const Eigen::VectorXd>(y.data(), n);
  return input;
}

/// Every row with g = c has y = 1.
LogisticInput with_a_sure_level() {
  const std::vector<double> y{1, 0, 1, 0, 1, 1, 1, 0, 1, 0, 0, 1,
                              1, 1, 1, 0, 1, 1, 1, 0, 1, 0, 1, 1};
  const std::vector<double> x{.3, -1.2, .8,  -.4,  1.1, .2, -.7, .9,  -1.5, .4, -.6, 1.6,
                              .9, 1.3,  -.9, -1.1, .2,  .6, 1.4, -.3, .5,   .2, .8,  -.1};
  std::vector<double> b(24, 0.0);
  std::vector<double> c(24, 0.0);
  for (std::size_t i = 0; i < 24; ++i) {
    b[i] = i % 3 == 1 ? 1.0 : 0.0;
    c[i] = i % 3 == 2 ? 1.0 : 0.0;
  }
  return input_of({b, c, x}, y);
}

// R: the roots of the profile of glm(y ~ g + x) on the rows with g != c; for c the lower one of glm
// with an offset, by uniroot to 1e-12 (from b = 8 on R's own likelihood breaks down).
TEST(LogisticProfile, OfQuasiSeparatedRowsEqualsRsLimitModel) {
  const std::vector<ProfileLimits> limits = profile_limits(with_a_sure_level());
  ASSERT_EQ(limits.size(), 4U);
  EXPECT_NEAR(limits[0].low.value(), -2.065124845, 1e-8);
  EXPECT_NEAR(limits[0].high.value(), 1.474705327, 1e-8);
  EXPECT_NEAR(limits[1].low.value(), -3.093912291, 1e-8);
  EXPECT_NEAR(limits[1].high.value(), 2.073796392, 1e-8);
  EXPECT_NEAR(limits[3].low.value(), 0.318822253, 1e-8);
  EXPECT_NEAR(limits[3].high.value(), 4.193555709, 1e-8);
  EXPECT_NEAR(limits[2].low.value(), 1.583314631, 1e-8);
  EXPECT_FALSE(limits[2].high.has_value());
  EXPECT_TRUE(limits[2].open_high);
  EXPECT_FALSE(limits[2].open_low);
  EXPECT_FALSE(limits[1].open_low || limits[1].open_high);
}

TEST(LogisticProfile, OfCompletelySeparatedRowsHasOneEndEach) {
  const std::vector<ProfileLimits> limits =
      profile_limits(input_of({{1, 2, 3, 4, 5, 6}}, {0, 0, 0, 1, 1, 1}));
  EXPECT_NEAR(limits[1].low.value(), 0.735298303, 1e-8);
  EXPECT_TRUE(limits[1].open_high);
  EXPECT_NEAR(limits[0].high.value(), -2.331620908, 1e-8);
  EXPECT_TRUE(limits[0].open_low);
  // Turned round, in other units and with rows as counts the ends only change their side and scale.
  LogisticInput turned = input_of({{1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3}}, {1, 1, 1, 0, 0, 0});
  EXPECT_NEAR(profile_limits(turned)[1].high.value(), -735.298303, 1e-5);
  EXPECT_TRUE(profile_limits(turned)[1].open_low);
}

/// The stupid way: bisection on whole fits without the column, its part in the offset.
double drop_at(const LogisticInput& input, std::size_t column, double value, double supremum) {
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
  rest.offset = value * input.design.col(static_cast<Eigen::Index>(column));
  const LogisticFit fit = fit_logistic(rest);
  return fit.log_likelihood ? 2.0 * (supremum - *fit.log_likelihood) : std::nan("");
}

TEST(LogisticProfile, EveryEndIsWhereAWholeFitHasFallenAsFar) {
  const double wanted = normal_factor(0.9) * normal_factor(0.9);
  LogisticOptions options;
  options.level = 0.9;
  int one_sided = 0;
  int two_sided = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    table::RandomStream random(17, 2, seed);
    std::vector<std::vector<double>> columns(2, std::vector<double>(14));
    std::vector<double> y(14);
    for (std::size_t i = 0; i < y.size(); ++i) {
      columns[0][i] = std::floor(3.0 * random.uniform());
      columns[1][i] = random.uniform() < 0.3 ? 1.0 : 0.0;
      const double eta = 2.0 * columns[0][i] - 2.0 + 3.0 * columns[1][i];
      y[i] = random.uniform() < 1.0 / (1.0 + std::exp(-eta)) ? 1.0 : 0.0;
    }
    const LogisticInput input = input_of(columns, y);
    const LogisticFit fit = fit_logistic(input);
    if (!fit.log_likelihood) {
      continue;
    }
    const std::vector<ProfileLimits> limits = profile_limits(input, options);
    for (std::size_t j = 0; j < limits.size(); ++j) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", column " + std::to_string(j));
      const CoefficientKind kind = fit.coefficients[j].kind;
      EXPECT_EQ(limits[j].open_high,
                kind == CoefficientKind::plus_infinity || kind == CoefficientKind::diverging);
      EXPECT_EQ(limits[j].open_low,
                kind == CoefficientKind::minus_infinity || kind == CoefficientKind::diverging);
      if (kind == CoefficientKind::not_estimable) {
        continue;
      }
      EXPECT_EQ(limits[j].low.has_value(), !limits[j].open_low);
      EXPECT_EQ(limits[j].high.has_value(), !limits[j].open_high);
      for (const auto& end : {limits[j].low, limits[j].high}) {
        // Without the column one class may be left, or nothing that overlaps: no stupid answer.
        const double drop = end ? drop_at(input, j, *end, *fit.log_likelihood) : wanted;
        if (!std::isnan(drop)) {
          EXPECT_NEAR(drop, wanted, 1e-6);
        }
      }
      one_sided += limits[j].open_high != limits[j].open_low ? 1 : 0;
      two_sided += limits[j].low && limits[j].high ? 1 : 0;
    }
  }
  EXPECT_GT(one_sided, 50);
  EXPECT_GT(two_sided, 200);
}

TEST(LogisticProfile, WorkGrowsWithTheCubeOfManyColumns) {
  const auto work = [](Eigen::Index rows, Eigen::Index columns) {
    LogisticInput input;
    input.design.resize(rows, columns);
    return profile_work(input);
  };
  EXPECT_LT(work(660, 8), kMostProfileWork);
  EXPECT_LT(work(1000000, 4), kMostProfileWork);
  EXPECT_LT(work(2000, 51), kMostProfileWork);
  EXPECT_GT(work(6000, 301), kMostProfileWork);
  EXPECT_NEAR(work(100, 200) / work(100, 100), 8.0, 0.1);
}

}  // namespace
}  // namespace tcert::statistics
