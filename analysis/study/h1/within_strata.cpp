#include "analysis/study/h1/within_strata.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/equivalence/scores_by_group.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/resampling/jackknife.hpp>
#include <string>
#include <utility>

namespace tcert::study {
namespace {

/// The rows whose stratum is known, with everything that pairs are made of.
struct StrataRows {
  std::vector<std::size_t> rows;
  table::Factor strata;
  table::Factor cluster;
  statistics::SurvivalOutcome success;  ///< 0 and 1 as times, so that C is the AUC.
  std::optional<statistics::SurvivalOutcome> censored;
  std::vector<std::vector<double>> values;  ///< Of each predictor.
};

StrataRows strata_rows(const H1Data& data, const std::vector<std::size_t>& rows) {
  StrataRows chosen;
  for (const std::size_t row : rows) {
    if (data.within->codes[row] != table::Factor::kMissing) {
      chosen.rows.push_back(row);
    }
  }
  chosen.strata = statistics::on_rows(*data.within, chosen.rows);
  chosen.cluster = statistics::on_rows(data.cluster, chosen.rows);
  std::vector<double> success;
  for (const std::size_t row : chosen.rows) {
    success.push_back(data.success[row]);
  }
  chosen.success = statistics::uncensored(success);
  if (data.censored) {
    chosen.censored = statistics::on_rows(*data.censored, chosen.rows);
  }
  for (const std::vector<double>& predictor : data.predictors) {
    chosen.values.emplace_back();
    for (const std::size_t row : chosen.rows) {
      chosen.values.back().push_back(predictor[row]);
    }
  }
  return chosen;
}

/// For the AUC a larger outcome is the better one, for C a shorter time.
std::vector<statistics::Predictor> predictors_of(const H1Data& data,
                                                 const StrataRows& chosen,
                                                 bool timed) {
  std::vector<statistics::Predictor> predictors;
  for (std::size_t k = 0; k < chosen.values.size(); ++k) {
    const bool larger_is_better = data.higher[k] == statistics::HigherMeans::success;
    predictors.push_back({data.names[k],
                          chosen.values[k],
                          larger_is_better == timed ? statistics::LargerMeans::shorter_time
                                                    : statistics::LargerMeans::longer_time});
  }
  return predictors;
}

/// A statistic of these rows alone, as one of all of them.
statistics::Statistic of_rows(const statistics::Statistic& part,
                              std::vector<std::size_t> rows,
                              std::size_t all) {
  statistics::Statistic statistic;
  statistic.rows = all;
  statistic.values = part.values;
  const auto shared = std::make_shared<const std::vector<std::size_t>>(std::move(rows));
  statistic.make_kernel = [part, shared]() -> statistics::StatisticKernel {
    return
        [kernel = part.make_kernel(), shared, chosen = std::vector<std::uint32_t>(shared->size())](
            std::span<const std::uint32_t> multiplicity, std::span<double> values) mutable {
          for (std::size_t i = 0; i < chosen.size(); ++i) {
            chosen[i] = multiplicity[(*shared)[i]];
          }
          kernel(chosen, values);
        };
  };
  statistic.leave_one_out = [part, shared](const statistics::ResamplingPlan& plan,
                                           std::span<std::vector<double>> out) {
    std::vector<std::uint32_t> unit;
    for (const std::size_t row : *shared) {
      unit.push_back(plan.unit_of(row));
    }
    const auto without =
        statistics::leave_one_out(part, statistics::ResamplingPlan::of_clusters(unit));
    // A unit of none of these rows changes nothing.
    std::vector<double> values(part.values);
    part.make_kernel()(std::vector<std::uint32_t>(part.rows, 1), values);
    const std::vector<std::uint32_t> compact = statistics::compact_codes(unit).codes;
    for (std::size_t value = 0; value < values.size(); ++value) {
      std::fill(out[value].begin(), out[value].end(), values[value]);
      for (std::size_t i = 0; i < unit.size(); ++i) {
        out[value][unit[i]] = without[value][compact[i]];
      }
    }
  };
  return statistic;
}

std::vector<std::size_t> all_rows(const H1Data& data) {
  std::vector<std::size_t> rows(data.rows());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

std::size_t pairs_of(const statistics::ConcordanceEstimate& estimate) {
  return static_cast<std::size_t>(estimate.counts.comparable());
}

/// Predictor `k`, and what the predictor under test gains over it.
void take(const statistics::ConcordanceResult& result,
          std::size_t k,
          H1Score& score,
          H1Score& gain,
          std::optional<double>& gain_p) {
  const statistics::ConcordanceEstimate& one = result.estimates[k];
  score.value = one.c;
  score.closed_form = one.interval;
  score.std_error = one.std_error;
  if (k > 0) {
    const statistics::ConcordanceDifference& difference = result.differences[k - 1];  // 0 less k
    gain.value = difference.difference;
    gain.closed_form = difference.interval;
    gain.std_error = difference.std_error;
    gain_p = difference.p_value;
  }
}

/// Pairs that C compares whatever the strata.
std::size_t all_c_pairs(const H1Data& data) {
  const statistics::Predictor first = data.timed(0);
  return pairs_of(statistics::concordance(*data.censored, {&first, 1}).estimates.front());
}

}  // namespace

std::optional<WithinScores> within_scores(const H1Data& data,
                                          const std::vector<std::size_t>& rows,
                                          double level) {
  if (!data.within) {
    return std::nullopt;
  }
  const StrataRows chosen = strata_rows(data, rows);
  if (chosen.rows.empty()) {
    return std::nullopt;
  }
  statistics::ConcordanceOptions options;
  options.level = level;
  options.strata = &chosen.strata;
  options.cluster = &chosen.cluster;
  WithinScores scores;
  scores.auc = statistics::concordance(chosen.success, predictors_of(data, chosen, false), options);
  if (chosen.censored) {
    scores.c =
        statistics::concordance(*chosen.censored, predictors_of(data, chosen, true), options);
  }
  return scores;
}

statistics::Statistic within_statistic(const H1Data& data) {
  StrataRows chosen = strata_rows(data, all_rows(data));
  std::vector<statistics::Statistic> parts{statistics::concordance_statistic(
      chosen.success, predictors_of(data, chosen, false), {}, &chosen.strata)};
  if (chosen.censored) {
    parts.push_back(statistics::concordance_statistic(
        *chosen.censored, predictors_of(data, chosen, true), {}, &chosen.strata));
  }
  const statistics::Statistic part = statistics::joined(std::move(parts));
  return chosen.rows.size() == data.rows() ? part
                                           : of_rows(part, std::move(chosen.rows), data.rows());
}

void add_within_strata(const H1Data& data, double level, H1Panel& panel) {
  const std::optional<WithinScores> scores = within_scores(data, all_rows(data), level);
  if (!scores) {
    return;
  }
  H1Strata& strata = panel.within;
  strata.columns = data.within_columns;
  strata.levels = data.within->levels.size();
  strata.missing = static_cast<std::size_t>(
      std::count(data.within->codes.begin(), data.within->codes.end(), table::Factor::kMissing));
  strata.auc_pairs = pairs_of(scores->auc.estimates.front());
  strata.all_auc_pairs = panel.successes * panel.failures;
  if (scores->c) {
    strata.c_pairs = pairs_of(scores->c->estimates.front());
    strata.all_c_pairs = all_c_pairs(data);
  }
  for (std::size_t k = 0; k < data.predictors.size() && k < panel.rows.size(); ++k) {
    H1WithinScores& within = panel.rows[k].within;
    take(scores->auc, k, within.auc, within.auc_gain, within.auc_gain_p);
    if (scores->c) {
      take(*scores->c, k, within.c, within.c_gain, within.c_gain_p);
    }
  }
}

}  // namespace tcert::study
