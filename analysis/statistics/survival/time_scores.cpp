#include <statistics/survival/time_scores.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <statistics/basics/compact_codes.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/survival/censoring_curve.hpp>
#include <statistics/survival/survival_curve.hpp>
#include <stdexcept>
#include <table/not_a_number.hpp>

namespace tcert::statistics {
namespace {

/// Values of one set of rows.
struct Scored {
  double auc = table::kNaN;
  double brier = table::kNaN;
};

void check(const SurvivalOutcome& outcome, std::size_t risks, const table::Factor* cluster) {
  if (outcome.event.size() != outcome.rows() || risks != outcome.rows() ||
      (cluster != nullptr && cluster->rows() != risks)) {
    throw std::invalid_argument("scores at a time: columns of different length");
  }
  if (outcome.left_truncated()) {
    throw std::invalid_argument("scores at a time: rows that enter late");
  }
}

bool is_case(const SurvivalOutcome& outcome, std::size_t row, double time) {
  return outcome.event[row] != 0 && outcome.stop[row] <= time;
}

CensoringCurve censoring_of(const SurvivalOutcome& outcome, const std::vector<std::size_t>& rows) {
  std::vector<std::uint8_t> censored;
  for (const std::uint8_t event : outcome.event) {
    censored.push_back(event == 0 ? 1 : 0);
  }
  return {outcome.stop, censored, rows};
}

Scored scored(const SurvivalOutcome& outcome,
              std::span<const double> risk,
              double time,
              std::vector<std::size_t> rows) {
  const CensoringCurve censoring = censoring_of(outcome, rows);
  std::sort(
      rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return risk[a] < risk[b]; });
  const double late = censoring.at(time);
  if (!(late > 0.0)) {
    return {};  // Nobody is known to be later, and censored rows cannot be weighted for.
  }
  double cases = 0.0;
  double controls = 0.0;  // So far: of lower risk.
  double pairs = 0.0;
  double squares = 0.0;
  for (std::size_t first = 0; first < rows.size();) {
    double tied_cases = 0.0;
    double tied_controls = 0.0;
    std::size_t last = first;
    for (; last < rows.size() && risk[rows[last]] == risk[rows[first]]; ++last) {
      const std::size_t row = rows[last];
      const double r = risk[row];
      if (is_case(outcome, row, time)) {
        const double weight = 1.0 / censoring.before(outcome.stop[row]);
        tied_cases += weight;
        squares += weight * (1.0 - r) * (1.0 - r);
      } else if (outcome.stop[row] > time) {
        tied_controls += 1.0 / late;
        squares += r * r / late;
      }
    }
    pairs += tied_cases * (controls + 0.5 * tied_controls);
    cases += tied_cases;
    controls += tied_controls;
    first = last;
  }
  return {cases > 0.0 && controls > 0.0 ? pairs / (cases * controls) : table::kNaN,
          rows.empty() ? table::kNaN : squares / static_cast<double>(rows.size())};
}

std::vector<std::size_t> rows_with_risk(std::span<const double> risk) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < risk.size(); ++row) {
    if (std::isfinite(risk[row])) {
      rows.push_back(row);
    }
  }
  return rows;
}

/// Within what such a number can be.
void clip(std::optional<Interval>& interval) {
  if (interval) {
    interval->low = std::clamp(interval->low, 0.0, 1.0);
    interval->high = std::clamp(interval->high, 0.0, 1.0);
  }
}

/// 1 - Kaplan-Meier of these rows, with its interval if there are rows.
RiskBin observed_of(const SurvivalOutcome& outcome,
                    const std::vector<std::size_t>& rows,
                    double time,
                    const table::Factor* cluster,
                    double level) {
  RiskBin bin;
  bin.rows = rows.size();
  CurveOptions options;
  std::optional<table::Factor> own;
  if (cluster != nullptr) {
    own = on_rows(*cluster, rows);
    options.cluster = &*own;
  }
  const SurvivalCurve curve = survival_curves(on_rows(outcome, rows), options).front();
  if (const SurvivalPoint* const point = curve.at(time)) {
    bin.observed = 1.0 - point->survival;
    if (point->survival > 0.0 && point->survival < 1.0) {
      const Interval survival =
          survival_interval(point->survival, point->log_std_error, IntervalScale::log_log, level);
      if (std::isfinite(survival.low) && std::isfinite(survival.high)) {
        bin.interval = Interval{1.0 - survival.high, 1.0 - survival.low, level};
      }
    }
  }
  return bin;
}

}  // namespace

TimeScores time_scores(const SurvivalOutcome& outcome,
                       std::span<const double> risk,
                       double time,
                       const table::Factor* cluster,
                       double level) {
  check(outcome, risk.size(), cluster);
  const std::vector<std::size_t> rows = rows_with_risk(risk);
  const Scored all = scored(outcome, risk, time, rows);
  TimeScores scores;
  scores.time = time;
  for (const std::size_t row : rows) {
    scores.cases += is_case(outcome, row, time) ? 1U : 0U;
    scores.controls += outcome.stop[row] > time ? 1U : 0U;
  }
  scores.auc.value = all.auc;
  scores.brier.value = all.brier;
  if (std::isnan(all.brier)) {
    scores.brier_null = table::kNaN;
    return scores;
  }
  const double share = observed_of(outcome, rows, time, nullptr, level).observed;
  const std::vector<double> same(risk.size(), share);
  scores.brier_null = scored(outcome, same, time, rows).brier;
  if (cluster == nullptr || too_much_to_leave_out(count_codes(cluster->codes), risk.size())) {
    return scores;
  }
  const CompactCodes compact = compact_codes(cluster->codes);
  std::vector<double> aucs;
  std::vector<double> briers;
  for (std::size_t unit = 0; unit < compact.count; ++unit) {
    std::vector<std::size_t> others;
    for (const std::size_t row : rows) {
      if (compact.codes[row] != unit) {
        others.push_back(row);
      }
    }
    const Scored without = scored(outcome, risk, time, std::move(others));
    aucs.push_back(without.auc);
    briers.push_back(without.brier);
  }
  scores.auc.spread = jackknife_estimate(all.auc, aucs, level);
  scores.brier.spread = jackknife_estimate(all.brier, briers, level);
  clip(scores.auc.spread.interval);
  clip(scores.brier.spread.interval);
  return scores;
}

std::vector<RiskBin> risk_bins(const SurvivalOutcome& outcome,
                               std::span<const double> risk,
                               double time,
                               std::size_t bins,
                               const table::Factor* cluster,
                               double level) {
  check(outcome, risk.size(), cluster);
  if (bins == 0) {
    throw std::invalid_argument("risk bins: none");
  }
  std::vector<std::size_t> rows = rows_with_risk(risk);
  std::stable_sort(
      rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return risk[a] < risk[b]; });
  std::vector<RiskBin> result;
  std::size_t first = 0;
  for (std::size_t bin = 0; bin < bins && first < rows.size(); ++bin) {
    std::size_t last = rows.size() * (bin + 1) / bins;
    if (last <= first) {
      continue;  // A tie before it holds its rows.
    }
    while (last < rows.size() && risk[rows[last]] == risk[rows[last - 1]]) {
      ++last;
    }
    std::vector<std::size_t> own(rows.begin() + static_cast<std::ptrdiff_t>(first),
                                 rows.begin() + static_cast<std::ptrdiff_t>(last));
    std::sort(own.begin(), own.end());
    RiskBin one = observed_of(outcome, own, time, cluster, level);
    for (const std::size_t row : own) {
      one.predicted += risk[row] / static_cast<double>(own.size());
    }
    result.push_back(one);
    first = last;
  }
  return result;
}

}  // namespace tcert::statistics
