#include <statistics/concordance/concordance.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <statistics/basics/normal.hpp>
#include <statistics/concordance/concordance_columns.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {
namespace {

void turn_over(ConcordancePairs& pairs) {
  const auto swap_sides = [](ConcordanceCounts& counts) {
    std::swap(counts.concordant, counts.discordant);
  };
  std::for_each(pairs.by_stratum.begin(), pairs.by_stratum.end(), swap_sides);
  for (RowPairs& row : pairs.rows) {
    row.net = -row.net;
  }
}

/// Change of C by a row's weight, to first order.
std::vector<double> dfbetas(const ConcordanceCounts& counts,
                            std::span<const RowPairs> rows,
                            std::span<const double> weights) {
  const double comparable = counts.comparable();
  const double somers_d = (counts.concordant - counts.discordant) / comparable;
  std::vector<double> result(rows.size());
  for (std::size_t row = 0; row < result.size(); ++row) {
    const double weight = weights.empty() ? 1.0 : weights[row];
    result[row] = 0.5 * weight * (rows[row].net - somers_d * rows[row].comparable) / comparable;
  }
  return result;
}

Condition condition(ConditionKind kind, ConditionSeverity severity, std::string column = {}) {
  return {kind, severity, std::move(column), {}};
}

void name_conditions(std::span<const double> values, ConcordanceEstimate& estimate) {
  if (!(estimate.counts.comparable() > 0.0)) {
    estimate.conditions.push_back(
        condition(ConditionKind::no_comparable_pairs, ConditionSeverity::error, estimate.name));
    return;
  }
  if (std::all_of(values.begin(), values.end(), [&](double v) { return v == values[0]; })) {
    estimate.conditions.push_back(
        condition(ConditionKind::all_tied, ConditionSeverity::warning, estimate.name));
  }
  // Removing rows leaves rounding in counts that would be 0 if weights are not whole.
  constexpr double kRounding = 1e-12;
  const double c = concordance_index(estimate.counts);
  if (c < kRounding || c > 1.0 - kRounding) {
    estimate.conditions.push_back(
        condition(ConditionKind::separated, ConditionSeverity::warning, estimate.name));
  }
}

/// dfbetas added up by cluster.
std::vector<double> by_cluster(std::span<const double> dfbeta,
                               std::span<const std::uint32_t> cluster,
                               std::size_t levels) {
  std::vector<double> sums(levels, 0.0);
  for (std::size_t row = 0; row < dfbeta.size(); ++row) {
    sums[cluster[row]] += dfbeta[row];
  }
  return sums;
}

double dot(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

ConcordanceDifference difference_of(const ConcordanceEstimate& first,
                                    const ConcordanceEstimate& second,
                                    std::span<const double> first_dfbeta,
                                    std::span<const double> second_dfbeta,
                                    double level) {
  ConcordanceDifference result;
  if (!first.c || !second.c) {
    return result;
  }
  const double difference = *first.c - *second.c;
  result.difference = difference;
  if (!first.variance || !second.variance) {
    return result;
  }
  // The squares of the differences, not var(a) + var(b) - 2 cov(a, b), which cancels.
  double variance = 0.0;
  for (std::size_t k = 0; k < first_dfbeta.size(); ++k) {
    variance += (first_dfbeta[k] - second_dfbeta[k]) * (first_dfbeta[k] - second_dfbeta[k]);
  }
  const double half = normal_factor(level) * std::sqrt(variance);
  result.variance = variance;
  result.std_error = std::sqrt(variance);
  result.interval = Interval{difference - half, difference + half, level};
  if (variance > 0.0) {
    const double z = difference / std::sqrt(variance);
    result.z = z;
    result.p_value = std::erfc(std::abs(z) / std::numbers::sqrt2);
  } else if (difference == 0.0) {
    result.conditions.push_back(condition(ConditionKind::same_ranking, ConditionSeverity::note));
    result.z = 0.0;
    result.p_value = 1.0;
  } else {
    result.conditions.push_back(
        condition(ConditionKind::zero_variance, ConditionSeverity::warning));
  }
  return result;
}

void name_row_conditions(std::size_t rows, bool clustered, ConcordanceResult& result) {
  if (result.missing > 0) {
    result.conditions.push_back({ConditionKind::missing_rows,
                                 ConditionSeverity::note,
                                 {},
                                 std::to_string(result.missing) + " rows left out"});
  }
  if (rows == 0) {
    result.conditions.push_back(condition(ConditionKind::no_rows, ConditionSeverity::error));
    return;
  }
  if (rows == 1) {
    result.conditions.push_back(condition(ConditionKind::too_few_rows, ConditionSeverity::error));
  }
  if (result.events == 0) {
    result.conditions.push_back(condition(ConditionKind::no_events, ConditionSeverity::error));
  }
  if (clustered) {
    add_cluster_conditions(result.clusters, "", result.conditions);
  }
}

ConcordanceEstimate estimate_of(const ConcordanceRows& rows,
                                const Predictor& predictor,
                                std::span<const double> values) {
  ConcordancePairs pairs = concordance_pairs(rows, values);
  if (predictor.larger == LargerMeans::shorter_time) {
    turn_over(pairs);
  }
  ConcordanceEstimate estimate;
  estimate.name = predictor.name;
  estimate.counts = pairs.total();
  estimate.by_stratum = std::move(pairs.by_stratum);
  name_conditions(values, estimate);
  const double comparable = estimate.counts.comparable();
  if (comparable > 0.0) {
    estimate.c = concordance_index(estimate.counts);
    estimate.null_variance = pairs.score_variance / (4.0 * comparable * comparable);
    estimate.dfbeta = dfbetas(estimate.counts, pairs.rows, rows.weight);
  }
  return estimate;
}

void set_variance(double variance, double level, ConcordanceEstimate& estimate) {
  const double half = normal_factor(level) * std::sqrt(variance);
  estimate.variance = variance;
  estimate.std_error = std::sqrt(variance);
  estimate.interval =
      Interval{std::max(0.0, *estimate.c - half), std::min(1.0, *estimate.c + half), level};
}

void compare(std::span<const std::span<const double>> dfbeta,
             double level,
             ConcordanceResult& result) {
  const std::size_t k = result.estimates.size();
  const auto size = static_cast<Eigen::Index>(k);
  result.covariance.setConstant(size, size, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < k; ++i) {
    for (std::size_t j = i; j < k; ++j) {
      if (result.estimates[i].variance && result.estimates[j].variance) {
        const double covariance = dot(dfbeta[i], dfbeta[j]);
        result.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = covariance;
        result.covariance(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = covariance;
      }
      if (j > i) {
        result.differences.push_back(
            difference_of(result.estimates[i], result.estimates[j], dfbeta[i], dfbeta[j], level));
        result.differences.back().first = i;
        result.differences.back().second = j;
      }
    }
  }
}

}  // namespace

SurvivalOutcome uncensored(std::span<const double> values) {
  SurvivalOutcome outcome;
  outcome.stop.assign(values.begin(), values.end());
  outcome.event.assign(values.size(), 1);
  return outcome;
}

ConcordanceResult concordance(const SurvivalOutcome& outcome,
                              std::span<const Predictor> predictors,
                              const ConcordanceOptions& options) {
  const ConcordanceColumns columns(outcome, predictors, options);
  ConcordanceResult result;
  result.missing = columns.missing();
  result.rows = columns.rows();
  result.n = columns.outcome().rows();
  const std::size_t strata = options.strata == nullptr ? 1 : options.strata->levels.size();
  const std::size_t clusters = options.cluster == nullptr ? 0 : options.cluster->levels.size();
  const auto& events = columns.outcome().event;
  result.events = static_cast<std::size_t>(std::count(events.begin(), events.end(), 1));
  result.clusters = count_codes(columns.cluster());
  name_row_conditions(columns.outcome().rows(), options.cluster != nullptr, result);

  const TimeOrder order = time_order(columns.outcome(), columns.strata(), strata);
  ConcordanceRows rows{&order, &columns.outcome(), columns.weights(), options.pair_weight};
  rows.last_event = options.latest.value_or(rows.last_event);
  std::vector<std::vector<double>> clustered;
  const bool has_variance = options.cluster == nullptr || result.clusters > 1;
  for (std::size_t i = 0; i < predictors.size(); ++i) {
    result.estimates.push_back(estimate_of(rows, predictors[i], columns.predictor(i)));
    ConcordanceEstimate& estimate = result.estimates.back();
    if (options.cluster != nullptr) {
      clustered.push_back(by_cluster(estimate.dfbeta, columns.cluster(), clusters));
    }
    const std::vector<double>& dfbeta =
        options.cluster != nullptr ? clustered.back() : estimate.dfbeta;
    if (estimate.c && has_variance) {
      set_variance(dot(dfbeta, dfbeta), options.level, estimate);
    }
  }
  std::vector<std::span<const double>> dfbeta(clustered.begin(), clustered.end());
  if (options.cluster == nullptr) {
    for (const ConcordanceEstimate& estimate : result.estimates) {
      dfbeta.emplace_back(estimate.dfbeta);
    }
  }
  compare(dfbeta, options.level, result);
  return result;
}

}  // namespace tcert::statistics
