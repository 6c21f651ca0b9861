#include <statistics/logistic/logistic_refit.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

LogisticInput random_input(Eigen::Index n) {
  LogisticInput input;
  input.design.resize(n, 3);
  input.columns = {"(Intercept)", "a", "b"};
  input.term_of = {0, 1, 2};
  input.terms = {"a", "b"};
  input.successes.resize(n);
  table::RandomStream random(3, 1, 0);
  for (Eigen::Index i = 0; i < n; ++i) {
    input.design(i, 0) = 1.0;
    input.design(i, 1) = 1e6 + 100.0 * random.normal();
    input.design(i, 2) = random.normal();
    const double eta = 0.01 * (input.design(i, 1) - 1e6) - 0.5 * input.design(i, 2);
    input.successes[i] = random.uniform() < 1.0 / (1.0 + std::exp(-eta)) ? 1.0 : 0.0;
  }
  return input;
}

TEST(LogisticRefit, EqualsAFitOfTheRepeatedRows) {
  LogisticInput input = random_input(80);
  const LogisticRefit refit(input);
  EXPECT_TRUE(refit.warm());
  for (std::uint64_t replicate = 0; replicate < 20; ++replicate) {
    table::RandomStream random(5, 2, replicate);
    std::vector<std::uint32_t> times(80, 0);
    for (int draw = 0; draw < 80; ++draw) {
      ++times[random.below(80)];
    }
    input.weights.resize(80);
    for (Eigen::Index i = 0; i < 80; ++i) {
      input.weights[i] = times[static_cast<std::size_t>(i)];
    }
    const LogisticFit fit = fit_logistic(input);
    const LogisticReplicate found = refit.fit(times);
    ASSERT_TRUE(found.coefficients.has_value());
    const Eigen::VectorXd columns = refit.column_coefficients(*found.coefficients);
    for (Eigen::Index j = 0; j < 3; ++j) {
      const double expected = *fit.coefficients[static_cast<std::size_t>(j)].estimate;
      EXPECT_NEAR(columns[j], expected, 1e-10 * std::abs(expected));
    }
    const Eigen::VectorXd eta = refit.linear_predictor(*found.coefficients);
    EXPECT_NEAR(1.0 / (1.0 + std::exp(-eta[7])), fit.fitted[7], 1e-10);
  }
}

TEST(LogisticRefit, SaysWhichReplicatesHaveNoEstimate) {
  const LogisticInput input = random_input(40);
  const LogisticRefit refit(input);
  std::vector<std::uint32_t> times(40, 0);
  for (Eigen::Index i = 0; i < 40; ++i) {
    times[static_cast<std::size_t>(i)] = input.successes[i] > 0.0 ? 1 : 0;
  }
  const LogisticReplicate one_class = refit.fit(times);
  EXPECT_FALSE(one_class.coefficients.has_value());
  EXPECT_EQ(one_class.termination, Termination::diverging);

  std::fill(times.begin(), times.end(), 0U);
  times[0] = 40;
  EXPECT_FALSE(refit.fit(times).coefficients.has_value());
  std::fill(times.begin(), times.end(), 0U);
  EXPECT_FALSE(refit.fit(times).coefficients.has_value());
}

}  // namespace
}  // namespace tcert::statistics
