// Robust variances that are singular, and likelihoods of many rows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <statistics/cox/cox.hpp>
#include <string>
#include <table/random.hpp>
#include <vector>

namespace tcert::statistics {
namespace {

/// `columns` of noise, rows dealt to the clusters in turn.
CoxData noise(std::uint64_t seed, std::size_t rows, Eigen::Index columns, std::uint32_t clusters) {
  table::RandomStream random(seed, 2, 0);
  CoxData data;
  data.design.resize(static_cast<Eigen::Index>(rows), columns);
  table::Factor cluster;
  for (std::uint32_t c = 0; c < clusters; ++c) {
    cluster.levels.push_back("D" + std::to_string(c));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    data.outcome.stop.push_back(std::ceil(-100.0 * std::log(random.uniform())) / 10.0);
    data.outcome.event.push_back(random.uniform() < 0.8 ? 1 : 0);
    cluster.codes.push_back(static_cast<std::uint32_t>(i) % clusters);
    for (Eigen::Index j = 0; j < columns; ++j) {
      data.design(static_cast<Eigen::Index>(i), j) = random.normal();
    }
  }
  data.cluster = std::move(cluster);
  for (Eigen::Index j = 0; j < columns; ++j) {
    data.columns.push_back("x" + std::to_string(j));
    data.terms.push_back(data.columns.back());
    data.term_of.push_back(static_cast<std::size_t>(j));
  }
  return data;
}

bool is_named(const CoxFit& fit, const std::string& column) {
  return std::any_of(fit.conditions.begin(), fit.conditions.end(), [&](const Condition& one) {
    return one.kind == ConditionKind::no_robust_variance && one.column == column;
  });
}

TEST(CoxVariance, WaldNeedsMoreClustersThanColumns) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (const std::uint32_t clusters : {2U, 3U, 4U, 5U, 8U, 12U}) {
      SCOPED_TRACE(std::to_string(seed) + ", " + std::to_string(clusters) + " clusters");
      const CoxFit fit = fit_cox(noise(seed, 48, 4, clusters));
      // The clusters' sums add up to 0, so the rank is one less than their number.
      EXPECT_EQ(fit.wald.has_value(), clusters > 4);
      EXPECT_EQ(is_named(fit, ""), clusters <= 4);
      if (fit.wald) {
        EXPECT_GE(fit.wald->statistic, 0.0);
        EXPECT_GE(fit.wald->p_value, 0.0);  // below the smallest double with 5 clusters
        EXPECT_LE(fit.wald->p_value, 1.0);
      }
      for (const auto& test : {fit.score, fit.robust_score, fit.likelihood_ratio}) {
        EXPECT_TRUE(!test || test->statistic >= 0.0);
      }
      EXPECT_GT(fit.coefficients[0].robust_se.value(), 0.0);
    }
  }
}

/// Within a stratum of its own: the residuals of the only cluster that has a part in a column add
/// up to 0, which is no variance.
TEST(CoxVariance, AColumnThatOneClusterTellsOfHasNone) {
  CoxData data = noise(3, 60, 1, 6);
  table::Factor strata = *data.cluster;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    if (strata.codes[i] != 2) {
      data.design(static_cast<Eigen::Index>(i), 0) = 0.0;
    }
  }
  data.strata = std::move(strata);
  const CoxFit fit = fit_cox(data);
  EXPECT_TRUE(fit.coefficients[0].estimate.has_value());
  EXPECT_FALSE(fit.coefficients[0].robust_se.has_value());
  EXPECT_FALSE(fit.coefficients[0].z.has_value());
  EXPECT_FALSE(fit.coefficients[0].p_value.has_value());
  EXPECT_FALSE(fit.wald.has_value());
  EXPECT_TRUE(is_named(fit, "x0"));
}

/// The log-likelihood's rounding is larger than what the last steps gain.
TEST(CoxVariance, ManyRowsAreFittedToTheEnd) {
  CoxData data = noise(11, 150'000, 1, 2);
  data.cluster.reset();
  for (std::size_t i = 0; i < data.rows(); ++i) {
    double& x = data.design(static_cast<Eigen::Index>(i), 0);
    x = std::round(10.0 * x) / 10.0;
    data.outcome.stop[i] = std::ceil(100.0 * data.outcome.stop[i] * std::exp(-0.7 * x)) / 100.0;
  }
  const CoxFit fit = fit_cox(data);
  EXPECT_EQ(fit.summary.termination, CoxTermination::converged);
  EXPECT_LE(fit.summary.iterations, 7U);
  EXPECT_LE(fit.summary.gradient_norm, 1e-6);
}

}  // namespace
}  // namespace tcert::statistics
