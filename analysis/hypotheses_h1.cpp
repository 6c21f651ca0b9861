#include "analysis/hypotheses_h1.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/quantile.hpp"

namespace tcert {
namespace {

using Feature = std::optional<double> Features::*;

struct Predictor {
  std::string_view name;
  HigherMeans higher;
  Feature feature;
};

using Predictors = std::array<Predictor, 4>;

constexpr Predictors kPaper{{
    {"tc_early", HigherMeans::success, &Features::tc_early},
    {"contacts_per_m", HigherMeans::failure, &Features::contacts_per_m},
    {"dwell", HigherMeans::failure, &Features::dwell},
    {"bend_variance", HigherMeans::failure, &Features::bend_variance},
}};

constexpr Predictors kLandmark{{
    {"tc_landmark", HigherMeans::success, &Features::tc_landmark},
    {"contacts_per_m_landmark", HigherMeans::failure, &Features::contacts_per_m_landmark},
    {"dwell_landmark", HigherMeans::failure, &Features::dwell_landmark},
    {"bend_variance_landmark", HigherMeans::failure, &Features::bend_variance_landmark},
}};

using Trials = std::vector<const FeatureRow*>;

std::optional<double> end_of(const FeatureRow& trial) {
  return trial.trial.time_s ? trial.trial.time_s : trial.features.end_s;
}

bool ends_in_window(const FeatureRow& trial) {
  const auto& window_end_s = trial.features.window_end_s;
  const auto end_s = end_of(trial);
  if (!window_end_s) {
    return trial.features.end_s.has_value();
  }
  return end_s && *end_s <= *window_end_s;
}

Trials running_at_landmark(const Trials& trials, double landmark_s, H1Panel& panel) {
  Trials running;
  for (const FeatureRow* trial : trials) {
    const auto end_s = end_of(*trial);
    const auto log_end_s = trial->features.end_s;
    if ((end_s && *end_s <= landmark_s) || (log_end_s && *log_end_s <= landmark_s)) {
      ++panel.ended_by_landmark;
    } else if (trial->features.still_at_landmark.value_or(false)) {
      ++panel.still_at_landmark;
    } else {
      running.push_back(trial);
    }
  }
  return running;
}

TcDistribution distribution(const Trials& trials, Feature tc, bool success) {
  TcDistribution result;
  result.success = success;
  std::vector<double> values;
  for (const FeatureRow* trial : trials) {
    if (*trial->trial.success != success) {
      continue;
    }
    ++result.trials;
    if (const auto& value = trial->features.*tc) {
      values.push_back(*value);
    }
  }
  result.missing = result.trials - values.size();
  result.negative = static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [](double value) { return value < 0.0; }));
  result.p10 = quantile(values, 0.10);
  result.p50 = quantile(values, 0.50);
  result.p90 = quantile(values, 0.90);
  return result;
}

/// Rows of the trials where every predictor is known.
struct CompleteCases {
  std::array<std::vector<double>, std::tuple_size_v<Predictors>> scores;
  std::vector<double> success;
  std::array<std::size_t, std::tuple_size_v<Predictors>> missing{};
};

CompleteCases complete_cases(const Trials& trials, const Predictors& predictors) {
  CompleteCases cases;
  for (const FeatureRow* trial : trials) {
    bool complete = true;
    for (std::size_t k = 0; k < predictors.size(); ++k) {
      const bool known = (trial->features.*predictors[k].feature).has_value();
      cases.missing[k] += known ? 0 : 1;
      complete = complete && known;
    }
    if (!complete) {
      continue;
    }
    for (std::size_t k = 0; k < predictors.size(); ++k) {
      cases.scores[k].push_back(*(trial->features.*predictors[k].feature));
    }
    cases.success.push_back(*trial->trial.success ? 1.0 : 0.0);
  }
  return cases;
}

void score(const Trials& trials, const Predictors& predictors, double level, H1Panel& panel) {
  const CompleteCases cases = complete_cases(trials, predictors);
  panel.trials = trials.size();
  panel.complete = cases.success.size();
  for (std::size_t k = 0; k < predictors.size(); ++k) {
    H1Row row;
    row.predictor = predictors[k].name;
    row.higher = predictors[k].higher;
    row.missing = cases.missing[k];
    row.auc = auc(cases.scores[k], cases.success, row.higher, {level, {}});
    if (k > 0) {
      row.tc_gain = paired_auc_test({cases.scores[0], predictors[0].higher},
                                    {cases.scores[k], row.higher},
                                    cases.success,
                                    {level, {}});
    }
    panel.rows.push_back(row);
  }
  for (const bool success : {true, false}) {
    panel.distribution.push_back(distribution(trials, predictors[0].feature, success));
  }
}

IssuedCount issued_count(const Trials& trials, bool success) {
  IssuedCount count;
  count.success = success;
  for (const FeatureRow* trial : trials) {
    if (*trial->trial.success == success) {
      ++count.trials;
      count.issued += trial->features.issued.value_or(false) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

std::string_view to_string(H1PanelKind kind) noexcept {
  return kind == H1PanelKind::paper ? "paper" : "landmark";
}

H1Table hypothesis_h1(std::span<const FeatureRow> trials, const H1Options& options) {
  H1Table table;
  table.trials = trials.size();
  Trials known;
  for (const FeatureRow& trial : trials) {
    if (trial.trial.success) {
      known.push_back(&trial);
    }
  }
  table.outcome_missing = trials.size() - known.size();
  table.issued = {issued_count(known, true), issued_count(known, false)};

  H1Panel paper;
  paper.kind = H1PanelKind::paper;
  for (const FeatureRow* trial : known) {
    if (ends_in_window(*trial)) {
      ++paper.ended_in_window;
      paper.failures_ended_in_window += *trial->trial.success ? 0 : 1;
    }
  }
  score(known, kPaper, options.level, paper);

  H1Panel landmark;
  landmark.kind = H1PanelKind::landmark;
  score(
      running_at_landmark(known, options.landmark_s, landmark), kLandmark, options.level, landmark);

  table.panels = {paper, landmark};
  return table;
}

}  // namespace tcert
