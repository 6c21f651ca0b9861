// What R says of models with few clusters (scripts/golden/clusters.R).

#include <gtest/gtest.h>

#include <statistics/clusters/cluster_variance.hpp>
#include <statistics/cox/cox_sandwich.hpp>
#include <statistics/logistic/logistic_sandwich.hpp>
#include <statistics/model/factor_levels.hpp>

#include "analysis/statistics/golden_table.hpp"

namespace tcert::statistics {
namespace {

using nlohmann::json;

json golden() { return golden_json("clusters.json"); }

std::vector<std::vector<double>> columns_of(const json& all) {
  std::vector<std::vector<double>> columns;
  for (const char* const name : {"day", "x", "z", "y", "time", "event"}) {
    columns.push_back(golden_numbers(all, name));
  }
  return columns;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

LogisticInput logistic_of(const std::vector<std::vector<double>>& columns) {
  LogisticInput input;
  input.columns = {"(Intercept)", "x", "z"};
  input.terms = {"x", "z"};
  input.term_of = {0, 1, 2};
  input.successes = vector_of(columns[3]);
  input.design = Eigen::MatrixXd::Ones(input.successes.size(), 3);
  input.design.col(1) = vector_of(columns[1]);
  input.design.col(2) = vector_of(columns[2]);
  input.cluster = levels_by_value(columns[0]);
  return input;
}

CoxData cox_of(const std::vector<std::vector<double>>& columns) {
  CoxData data;
  data.columns = {"x", "z"};
  data.terms = {"x", "z"};
  data.term_of = {0, 1};
  data.outcome.stop = columns[4];
  data.outcome.event.assign(columns[5].begin(), columns[5].end());
  data.design.resize(static_cast<Eigen::Index>(columns[0].size()), 2);
  data.design.col(0) = vector_of(columns[1]);
  data.design.col(1) = vector_of(columns[2]);
  data.cluster = levels_by_value(columns[0]);
  return data;
}

void expect_close(const Eigen::VectorXd& mine, const json& r, double relative, const char* what) {
  ASSERT_EQ(mine.size(), static_cast<Eigen::Index>(r.size())) << what;
  for (Eigen::Index j = 0; j < mine.size(); ++j) {
    const auto expected = r[static_cast<std::size_t>(j)].get<double>();
    EXPECT_NEAR(mine(j), expected, relative * std::abs(expected)) << what << ' ' << j;
  }
}

void expect_left_out(const Eigen::MatrixXd& mine, const json& r) {
  const Eigen::Map<const Eigen::VectorXd> all(mine.data(), mine.size());
  expect_close(all, json::parse(r.dump()), 1e-7, "left out");
}

void expect_wild(const ClusteredFit& fit, const json& all, const json& of) {
  const auto parts = fit.parts_at(of["held"]["k"], of["held"]["value"]);
  ASSERT_TRUE(parts);
  for (std::size_t i = 0; i < all["weights"].size(); ++i) {
    const Eigen::VectorXd weights = vector_of(all["weights"][i].get<std::vector<double>>());
    const auto expected = of["wild"][i].get<double>();
    EXPECT_NEAR(wild_t_squared(*parts, of["held"]["k"], weights), expected, 1e-8 * expected);
  }
}

/// p x G in R is a matrix: its rows are the coefficients'.
json by_cluster(const json& rows) {
  json flat = json::array();
  for (std::size_t g = 0; g < rows[0].size(); ++g) {
    for (const json& row : rows) {
      flat.push_back(row[g]);
    }
  }
  return flat;
}

TEST(ClusterGolden, LogisticRegressionEqualsClubSandwich) {
  const json all = golden();
  const json& r = all["glm"];
  const LogisticInput input = logistic_of(columns_of(all));
  LogisticOptions options;
  options.variance = CoefficientVariance::robust;
  const LogisticFit fit = fit_logistic(input, options);
  const auto clustered = clustered_fit(input, fit);
  ASSERT_TRUE(clustered);
  expect_close(clustered->parts.estimates, r["estimate"], 1e-9, "estimate");
  expect_close(sandwich_cr0(clustered->parts).diagonal(), r["cr0"], 1e-9, "CR0");
  expect_close(fit.covariance.diagonal(), r["cr0"], 1e-9, "CR0 of the fit");
  expect_close(sandwich_cr2(clustered->parts).diagonal(), r["cr2"], 1e-8, "CR2");
  expect_close(sandwich_cr2(clustered->parts).diagonal(), r["cr2_glm"], 6e-3, "CR2 by rows");
  expect_close(satterthwaite_df(clustered->parts), r["df"], 1e-8, "df");
  expect_left_out(clustered->left_out().values, by_cluster(r["left_out"]));
  expect_wild(*clustered, all, r);
  const auto cr2 = cluster_inferences(*clustered, ClusterInference::cr2, {}).of;
  for (std::size_t j = 0; j < cr2.size(); ++j) {
    EXPECT_NEAR(*cr2[j].p_value, r["p"][j].get<double>(), 1e-8);
  }
  const auto cr1 = cluster_inferences(*clustered, ClusterInference::cr1, {}).of;
  for (std::size_t j = 0; j < cr1.size(); ++j) {
    const auto variance = r["cr1"][j].get<double>();
    EXPECT_NEAR(*cr1[j].standard_error, std::sqrt(variance), 1e-9);
    EXPECT_EQ(*cr1[j].df, 8.0);
  }
}

TEST(ClusterGolden, CoxModelEqualsTheFormulasWrittenOut) {
  const json all = golden();
  const json& r = all["cox"];
  const CoxData data = cox_of(columns_of(all));
  CoxOptions options;
  options.ties = Ties::breslow;
  const CoxFit fit = fit_cox(data, options);
  const auto clustered = clustered_fit(data, fit);
  ASSERT_TRUE(clustered);
  expect_close(clustered->parts.estimates, r["estimate"], 1e-8, "estimate");
  expect_close(sandwich_cr0(clustered->parts).diagonal(), r["cr0"], 1e-8, "CR0");
  expect_close(sandwich_cr2(clustered->parts).diagonal(), r["cr2"], 1e-7, "CR2");
  expect_close(satterthwaite_df(clustered->parts), r["df"], 1e-7, "df");
  expect_left_out(clustered->left_out().values, by_cluster(r["left_out"]));
  expect_wild(*clustered, all, r);
  const CoxFit efron = fit_cox(data);
  const auto of_efron = clustered_fit(data, efron);
  ASSERT_TRUE(of_efron);
  expect_close(sandwich_cr0(of_efron->parts).diagonal(), r["efron_cr0"], 1e-8, "CR0, Efron");
}

/// The interval is the set of values that the test does not reject.
TEST(WildBootstrap, TheIntervalInvertsTheTest) {
  const CoxData data = cox_of(columns_of(golden()));
  const auto fit = clustered_fit(data, fit_cox(data));
  ASSERT_TRUE(fit);
  WildOptions options;
  options.replicates = 399;
  const auto estimates = cluster_inferences(*fit, ClusterInference::wild, options).of;
  ASSERT_TRUE(estimates[0].interval);
  const double step = 0.01 * *estimates[0].standard_error;
  const auto p_at = [&](double value) {
    return wild_p_value(fit->parts_at(0, value).value(), 0, options).value();
  };
  EXPECT_LE(p_at(estimates[0].interval->low - step), 0.05);
  EXPECT_GT(p_at(estimates[0].interval->low + step), 0.05);
  EXPECT_GT(p_at(estimates[0].interval->high - step), 0.05);
  EXPECT_LE(p_at(estimates[0].interval->high + step), 0.05);
  EXPECT_GT(*estimates[0].p_value, 0.0);
}

/// A column that varies within a single cluster has no variance over clusters, and no plausible
/// one.
TEST(ClusterInference, AColumnOfOneClusterHasNoEstimateOfItsSpread) {
  const std::vector<std::vector<double>> columns = columns_of(golden());
  LogisticInput input = logistic_of(columns);
  for (Eigen::Index i = 0; i < input.design.rows(); ++i) {
    input.design(i, 2) = columns[0][static_cast<std::size_t>(i)] == 3.0 ? 1.0 : 0.0;
  }
  LogisticOptions options;
  options.variance = CoefficientVariance::robust;
  const auto fit = clustered_fit(input, fit_logistic(input, options));
  ASSERT_TRUE(fit);
  const auto left_out = cluster_inferences(*fit, ClusterInference::jackknife, {}).of;
  EXPECT_FALSE(left_out[2].p_value);
  EXPECT_TRUE(left_out[1].p_value);
}

/// Without cluster "d3" the level it alone holds both outcomes of has no finite estimate.
TEST(ClusterInference, ARefitThatSeparatesCostsOnlyItsOwnColumn) {
  LogisticInput input;
  input.columns = {"(Intercept)", "x", "dark"};
  input.terms = {"x", "dark"};
  input.term_of = {0, 1, 2};
  const Eigen::Index rows = 60;
  input.design = Eigen::MatrixXd::Ones(rows, 3);
  input.successes.resize(rows);
  input.cluster.emplace();
  input.cluster->levels = {"d1", "d2", "d3", "d4", "d5"};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto day = static_cast<std::uint32_t>(i % 5);
    input.cluster->codes.push_back(day);
    input.design(i, 1) = static_cast<double>((i * 7) % 11);
    const bool dark = i >= 40;
    input.design(i, 2) = dark ? 1.0 : 0.0;
    input.successes(i) =
        dark ? (day == 2 && i >= 50 ? 0.0 : 1.0) : static_cast<double>((i * i) % 3 == 1);
  }
  LogisticOptions options;
  options.variance = CoefficientVariance::robust;
  const LogisticFit fit = fit_logistic(input, options);
  ASSERT_EQ(fit.separation, Separation::none);
  const ClusterInferences all = cluster_inferences(input, fit, ClusterInference::jackknife, {});
  EXPECT_TRUE(all.of[1].standard_error);
  EXPECT_FALSE(all.of[2].standard_error);
  ASSERT_EQ(all.conditions.size(), 1U);
  EXPECT_EQ(all.conditions.front().kind, ConditionKind::no_jackknife);
  EXPECT_NE(all.conditions.front().detail.find("without 'd3': quasi-complete separation"),
            std::string::npos)
      << all.conditions.front().detail;
}

/// Parts of 5e7 numbers and more are not made: the jackknife refits without them, what needs them
/// says that it cannot be had.
TEST(ClusterInference, WhatIsTooLargeForItsPartsIsSaid) {
  const Eigen::Index p = 110;
  const Eigen::Index rows = 4400;
  CoxData data;
  data.design.resize(rows, p);
  data.cluster.emplace();
  data.cluster->levels = {"a", "b", "c"};
  std::uint32_t state = 1;
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < p; ++j) {
      state = state * 1664525U + 1013904223U;
      data.design(i, j) = static_cast<double>(state >> 16U) / 65536.0;
    }
    data.outcome.stop.push_back(1.0 + static_cast<double>((i * 37) % rows));
    data.outcome.event.push_back(1);
    data.cluster->codes.push_back(static_cast<std::uint32_t>(i % 3));
  }
  for (Eigen::Index j = 0; j < p; ++j) {
    data.columns.push_back("x" + std::to_string(j));
    data.terms.push_back(data.columns.back());
    data.term_of.push_back(static_cast<std::size_t>(j));
  }
  const CoxFit fit = fit_cox(data);
  ASSERT_FALSE(clustered_fit(data, fit));
  const ClusterInferences jackknife = cluster_inferences(data, fit, {}, {});
  EXPECT_EQ(jackknife.by, ClusterInference::jackknife);
  EXPECT_TRUE(jackknife.of.front().standard_error);
  EXPECT_TRUE(jackknife.conditions.empty());
  for (const ClusterInference asked : {ClusterInference::cr2, ClusterInference::wild}) {
    const ClusterInferences other = cluster_inferences(data, fit, asked, {});
    EXPECT_FALSE(other.of.front().standard_error);
    ASSERT_EQ(other.conditions.size(), 1U);
    EXPECT_EQ(other.conditions.front().kind, ConditionKind::no_robust_variance);
  }
}

}  // namespace
}  // namespace tcert::statistics
