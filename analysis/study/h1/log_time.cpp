#include "analysis/study/h1/log_time.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <table/not_a_number.hpp>

#include "analysis/study/h1/comparison.hpp"
#include "analysis/study/h1/hazard_ratio.hpp"

namespace tcert::study {
namespace {

LogTimes log_times(const H1Data& data) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < data.rows(); ++i) {
    if (data.censored->event[i] == 1) {
      rows.push_back(static_cast<Eigen::Index>(i));
    }
  }
  LogTimes times;
  times.log_time.resize(static_cast<Eigen::Index>(rows.size()));
  times.predictors.resize(times.log_time.size(), static_cast<Eigen::Index>(data.predictors.size()));
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::size_t>(rows[i]);
    const double start = data.censored->left_truncated() ? data.censored->start[row] : 0.0;
    times.log_time[static_cast<Eigen::Index>(i)] = std::log(data.censored->stop[row] - start);
    codes.push_back(data.cluster.codes[row]);
  }
  for (std::size_t k = 0; k < data.predictors.size(); ++k) {
    times.predictors.col(static_cast<Eigen::Index>(k)) = per_sd(data, k)(rows);
  }
  const statistics::CompactCodes compact = statistics::compact_codes(codes);
  times.cluster.levels = statistics::cluster_names(data.cluster, codes, compact);
  times.cluster.codes = compact.codes;
  return times;
}

/// The columns of a row's model, the one that its ratio is of first.
std::vector<std::size_t> columns_of_row(const H1Panel& panel, std::size_t row, std::size_t count) {
  const H1RowKind kind = panel.rows[row].kind;
  if (kind == H1RowKind::predictor || kind == H1RowKind::rival) {
    return {row};
  }
  std::vector<std::size_t> columns;
  for (std::size_t k = kind == H1RowKind::added ? 0 : 1; k < count; ++k) {
    columns.push_back(k);
  }
  return columns;
}

void take_fit(const statistics::LmmFit& fit, bool has_ratio, H1Row& row) {
  H1LogTime& found = row.log_time;
  found.r2_marginal = fit.r2_marginal;
  found.r2_conditional = fit.r2_conditional;
  if (!fit.random.empty()) {
    found.sd_cluster = fit.random.front().sd.front();
  }
  if (has_ratio && fit.coefficients.size() > 1 && fit.coefficients[1].estimate) {
    const statistics::LmmCoefficient& one = fit.coefficients[1];
    found.ratio = std::exp(*one.estimate);
    found.p_value = one.p_value;
    if (one.interval) {
      found.interval = statistics::Interval{
          std::exp(one.interval->low), std::exp(one.interval->high), one.interval->level};
    }
  }
  for (statistics::Condition condition : fit.conditions) {
    // One model of many: its error costs its own row.
    condition.severity = std::min(condition.severity, statistics::ConditionSeverity::warning);
    condition.detail =
        "linear mixed model" + (condition.detail.empty() ? "" : ": " + condition.detail);
    row.conditions.push_back(std::move(condition));
  }
}

void add_gains(const Eigen::MatrixXd& left_out, double level, H1Panel& panel) {
  for (std::size_t r = 0; r < panel.rows.size(); ++r) {
    const auto pair = comparison_of(panel, r);
    if (!pair) {
      continue;
    }
    const auto& better = panel.rows[pair->better].log_time.r2_marginal;
    const auto& than = panel.rows[pair->than].log_time.r2_marginal;
    if (!better || !than) {
      continue;
    }
    H1LogTime& found = panel.rows[r].log_time;
    found.r2_gain = *better - *than;
    const Eigen::VectorXd gains = (left_out.row(static_cast<Eigen::Index>(pair->better)) -
                                   left_out.row(static_cast<Eigen::Index>(pair->than)))
                                      .transpose();
    const statistics::ClusterT by_t = statistics::jackknife_estimate(
        *found.r2_gain, {gains.data(), static_cast<std::size_t>(gains.size())}, level);
    found.r2_gain_interval = by_t.interval;
    found.r2_gain_p = by_t.p_value;
  }
}

}  // namespace

statistics::LmmFit log_time_fit(const LogTimes& times,
                                const std::vector<std::size_t>& columns,
                                double level,
                                std::int64_t without) {
  std::vector<Eigen::Index> rows;
  std::vector<std::uint32_t> codes;
  for (std::size_t i = 0; i < times.cluster.codes.size(); ++i) {
    if (static_cast<std::int64_t>(times.cluster.codes[i]) != without) {
      rows.push_back(static_cast<Eigen::Index>(i));
      codes.push_back(times.cluster.codes[i]);
    }
  }
  statistics::LmmInput input;
  const auto count = static_cast<Eigen::Index>(rows.size());
  input.design.resize(count, static_cast<Eigen::Index>(columns.size()) + 1);
  input.design.col(0).setOnes();
  input.columns = {"(Intercept)"};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    input.design.col(static_cast<Eigen::Index>(k) + 1) =
        times.predictors.col(static_cast<Eigen::Index>(columns[k]))(rows);
    input.columns.push_back("x" + std::to_string(columns[k]));
  }
  input.response = "log time";
  input.y = times.log_time(rows);
  input.random = {{"cluster",
                   {std::move(codes), times.cluster.levels},
                   Eigen::MatrixXd::Ones(count, 1),
                   {"(Intercept)"}}};
  statistics::LmmOptions options;
  options.level = level;
  options.test_terms = false;
  return statistics::fit_lmm(input, options);
}

Eigen::MatrixXd r2_left_out(const LogTimes& times,
                            const std::vector<std::vector<std::size_t>>& models) {
  const std::size_t clusters = times.cluster.levels.size();
  Eigen::MatrixXd values(static_cast<Eigen::Index>(models.size()),
                         static_cast<Eigen::Index>(clusters));
  tbb::parallel_for(std::size_t{0}, clusters, [&](std::size_t g) {
    for (std::size_t m = 0; m < models.size(); ++m) {
      values(static_cast<Eigen::Index>(m), static_cast<Eigen::Index>(g)) =
          log_time_fit(times, models[m], 0.95, static_cast<std::int64_t>(g))
              .r2_marginal.value_or(table::kNaN);
    }
  });
  return values;
}

void add_log_time(const H1Data& data, const H1Options& options, H1Panel& panel) {
  if (!panel.has_clusters || panel.clusters == data.rows() || !data.censored) {
    return;
  }
  const LogTimes times = log_times(data);
  std::vector<std::vector<std::size_t>> models;
  for (std::size_t r = 0; r < panel.rows.size(); ++r) {
    models.push_back(columns_of_row(panel, r, data.predictors.size()));
    take_fit(log_time_fit(times, models.back(), options.level),
             panel.rows[r].kind != H1RowKind::together,
             panel.rows[r]);
  }
  const bool refits = times.cluster.levels.size() <= statistics::kMostJackknifeClusters;
  add_gains(
      refits ? r2_left_out(times, models)
             : Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(models.size()), 2, table::kNaN),
      options.level,
      panel);
}

}  // namespace tcert::study
