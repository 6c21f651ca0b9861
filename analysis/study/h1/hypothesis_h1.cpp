#include "analysis/study/h1/hypothesis_h1.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/holm.hpp>
#include <statistics/resampling/bootstrap_difference.hpp>
#include <stdexcept>
#include <utility>

#include "analysis/study/h1/closed_forms.hpp"
#include "analysis/study/h1/comparison.hpp"
#include "analysis/study/h1/curves.hpp"
#include "analysis/study/h1/h1_score.hpp"
#include "analysis/study/h1/incidence_by_quartile.hpp"
#include "analysis/study/h1/issued_counts.hpp"
#include "analysis/study/h1/joint_statistic.hpp"
#include "analysis/study/h1/log_time.hpp"
#include "analysis/study/h1/mixed_effects.hpp"
#include "analysis/study/h1/model_scores.hpp"
#include "analysis/study/h1/out_of_fold.hpp"
#include "analysis/study/h1/panel_data.hpp"
#include "analysis/study/h1/withhold.hpp"
#include "analysis/study/h1/within_strata.hpp"

namespace tcert::study {
namespace {

/// Streams of the seed; the panels must not share draws.
constexpr std::uint32_t kH1Stream = 0x4831;  // "H1"

void name_rows(const H1Data& data, H1Panel& panel) {
  for (std::size_t k = 0; k < data.names.size(); ++k) {
    panel.rows[k].name = data.names[k];
    panel.rows[k].kind = k == 0 ? H1RowKind::predictor : H1RowKind::rival;
    panel.rows[k].higher = data.higher[k];
  }
}

void add_model_rows(const H1Models& models, H1Panel& panel) {
  for (std::size_t m = 0; m < models.models.size(); ++m) {
    H1Row row;
    row.kind = m == 0 ? H1RowKind::together : H1RowKind::added;
    row.name = m == 0 ? "rivals together" : "rivals + " + panel.rows.front().name;
    panel.rows.push_back(std::move(row));
  }
}

/// Scores of the rows of one bootstrap.
class RowScores {
 public:
  RowScores(const statistics::BootstrapResult& result,
            const statistics::ResamplingPlan& plan,
            const H1Options& options,
            H1Panel& panel)
      : result_(result), plan_(plan), options_(options), panel_(panel) {}

  void take(std::size_t value, const std::string& quantity, std::size_t row, H1Score& score) {
    take_of(result_, value, quantity, row, score);
  }

  /// Value `better` less value `than`, resample by resample.
  void take_gain(std::size_t better,
                 std::size_t than,
                 const std::string& quantity,
                 std::size_t row,
                 H1Score& score) {
    take_difference({better}, {than}, "gain of " + quantity, row, score);
  }

  /// The values `added` less those `taken`.
  void take_difference(const std::vector<std::size_t>& added,
                       const std::vector<std::size_t>& taken,
                       const std::string& quantity,
                       std::size_t row,
                       H1Score& score) {
    take_of(statistics::paired_difference(result_, plan_, added, taken), 0, quantity, row, score);
  }

 private:
  void take_of(const statistics::BootstrapResult& result,
               std::size_t value,
               const std::string& quantity,
               std::size_t row,
               H1Score& score) {
    statistics::Conditions met;
    take_score(result, value, options_, quantity, score, met);
    for (statistics::Condition& condition : met) {
      condition.column = panel_.rows[row].name;
      panel_.rows[row].conditions.push_back(std::move(condition));
    }
  }

  const statistics::BootstrapResult& result_;
  const statistics::ResamplingPlan& plan_;
  const H1Options& options_;
  H1Panel& panel_;
};

void take_within(const H1Layout& layout, RowScores& scores, H1Panel& panel) {
  for (std::size_t r = 0; r < layout.predictors; ++r) {
    H1WithinScores& within = panel.rows[r].within;
    scores.take(layout.auc_within(r), "AUC within strata", r, within.auc);
    if (layout.has_time) {
      scores.take(layout.c_within(r), "C within strata", r, within.c);
    }
    if (r > 0) {
      scores.take_gain(
          layout.auc_within(0), layout.auc_within(r), "AUC within strata", r, within.auc_gain);
      scores.take_difference({H1Layout::auc(0), layout.auc_within(r)},
                             {H1Layout::auc(r), layout.auc_within(0)},
                             "gain of AUC between strata",
                             r,
                             within.auc_gain_between);
      if (layout.has_time) {
        scores.take_gain(
            layout.c_within(0), layout.c_within(r), "C within strata", r, within.c_gain);
        scores.take_difference({layout.c(0), layout.c_within(r)},
                               {layout.c(r), layout.c_within(0)},
                               "gain of C between strata",
                               r,
                               within.c_gain_between);
      }
    }
  }
}

/// What the jackknife went through on its way.
void take_left_out(const H1Data& data,
                   const H1Layout& layout,
                   const statistics::BootstrapResult& result,
                   H1Panel& panel) {
  for (std::size_t g = 0; panel.has_clusters && g < result.units; ++g) {
    for (std::size_t r = 0; r < panel.rows.size(); ++r) {
      const auto value = [&](bool timed, std::size_t row) {
        return timed && !layout.has_time
                   ? std::nan("")
                   : result.left_out[timed ? layout.c(row) : H1Layout::auc(row)][g];
      };
      const auto pair = comparison_of(panel, r);
      const auto gain = [&](bool timed) {
        return pair ? value(timed, pair->better) - value(timed, pair->than) : std::nan("");
      };
      panel.left_out.push_back({data.cluster.levels[g],
                                panel.rows[r].name,
                                value(false, r),
                                gain(false),
                                value(true, r),
                                gain(true)});
    }
  }
}

void bootstrap_rows(const H1Data& data,
                    const H1Models& models,
                    const H1Options& options,
                    const Watch& watch,
                    H1Panel& panel) {
  H1Layout layout;
  layout.predictors = data.predictors.size();
  layout.models = models.models.size();
  layout.has_time = data.censored.has_value();
  layout.has_strata = !panel.within.columns.empty();
  const statistics::ResamplingPlan plan =
      statistics::ResamplingPlan::of_clusters(data.cluster.codes);
  statistics::BootstrapOptions bootstrap_options;
  bootstrap_options.replicates = options.replicates;
  bootstrap_options.seed = options.seed;
  bootstrap_options.analysis = kH1Stream + static_cast<std::uint32_t>(panel.kind);
  bootstrap_options.advance = watch.on_advance;
  watch.begin(resamples_of(panel.kind), options.replicates);
  const statistics::BootstrapResult result =
      statistics::bootstrap(joint_statistic(data, layout, models), plan, bootstrap_options);

  RowScores scores(result, plan, options, panel);
  for (std::size_t r = 0; r < panel.rows.size(); ++r) {
    H1Row& row = panel.rows[r];
    scores.take(H1Layout::auc(r), "AUC", r, row.auc);
    if (layout.has_time) {
      scores.take(layout.c(r), "C", r, row.c);
    }
    if (const auto pair = comparison_of(panel, r)) {
      scores.take_gain(
          H1Layout::auc(pair->better), H1Layout::auc(pair->than), "AUC", r, row.auc_gain);
      if (layout.has_time) {
        scores.take_gain(layout.c(pair->better), layout.c(pair->than), "C", r, row.c_gain);
      }
    }
  }
  if (layout.has_strata) {
    take_within(layout, scores, panel);
  }
  take_left_out(data, layout, result, panel);
}

/// The family: gains over each rival in AUC and in C.
void adjust(H1Panel& panel) {
  std::vector<std::optional<double>> p;
  for (H1Row& row : panel.rows) {
    if (row.kind == H1RowKind::rival) {
      row.auc_p = row.auc_gain.p_value;
      row.c_p = row.c_gain.p_value;
      p.push_back(row.auc_p);
      p.push_back(row.c_p);
    }
  }
  const std::vector<std::optional<double>> adjusted = statistics::holm(p);
  std::size_t next = 0;
  for (H1Row& row : panel.rows) {
    if (row.kind == H1RowKind::rival) {
      row.auc_holm = adjusted[next++];
      row.c_holm = adjusted[next++];
    }
  }
}

H1Panel panel_of(const table::DataTable& table,
                 const H1Options& options,
                 const Watch& watch,
                 H1PanelKind kind) {
  H1Panel panel;
  panel.kind = kind;
  const H1Data data = panel_data(table, options, panel);
  name_rows(data, panel);
  if (!can_be_scored(panel)) {
    return panel;
  }
  const H1Models models = options.models ? h1_models(data) : H1Models{};
  add_model_rows(models, panel);
  add_within_strata(data, options.level, panel);
  bootstrap_rows(data, models, options, watch, panel);
  add_closed_forms(data, models, options, panel);
  if (options.models) {
    add_out_of_fold(data, models, options, panel);
    add_mixed_effects(data, options, panel);
    add_log_time(data, options, panel);
    add_curves(data, models, options, panel);
  }
  add_incidence_by_quartile(data, panel);
  adjust(panel);
  withhold_if_few(options, panel);
  // A fit that fails costs its own number, not the table.
  for (H1Row& row : panel.rows) {
    for (statistics::Condition& condition : row.conditions) {
      condition.severity = std::min(condition.severity, statistics::ConditionSeverity::warning);
    }
  }
  return panel;
}

void validate(const H1Options& options) {
  if (options.predictors.empty()) {
    throw std::invalid_argument("H1 needs a predictor");
  }
  if (!(options.level > 0.0 && options.level < 1.0)) {
    throw std::invalid_argument("H1: the level must be in (0, 1)");
  }
  if (options.replicates < 1 || options.folds < 2) {
    throw std::invalid_argument("H1 needs a replicate and two folds");
  }
}

}  // namespace

std::vector<H1Predictor> paper_predictors() {
  return {{"tc_early", statistics::HigherMeans::success, "tc_landmark"},
          {"contacts_per_m", statistics::HigherMeans::failure, "contacts_per_m_landmark"},
          {"dwell", statistics::HigherMeans::failure, "dwell_landmark"},
          {"bend_variance", statistics::HigherMeans::failure, "bend_variance_landmark"}};
}

std::string_view to_string(H1PanelKind kind) noexcept {
  return kind == H1PanelKind::paper ? "paper" : "landmark";
}

std::string resamples_of(H1PanelKind kind) {
  return std::string(to_string(kind)) + " panel, resamples";
}

H1Table hypothesis_h1(const table::DataTable& table, const H1Options& options, const Watch& watch) {
  validate(options);
  require_columns(table, options);
  H1Table h1;
  h1.options = options;
  h1.trials = table.rows;
  h1.issued = issued_counts(table, options);
  h1.panels.push_back(panel_of(table, options, watch, H1PanelKind::paper));
  if (has_landmark(table, options)) {
    h1.panels.push_back(panel_of(table, options, watch, H1PanelKind::landmark));
  }
  h1.outcome_missing = table.rows - h1.panels.front().trials;  // The paper panel excludes no one.
  return h1;
}

std::vector<std::string> columns_of(const H1Options& options) {
  std::vector<std::string> columns{options.success,
                                   options.time,
                                   options.cluster,
                                   options.strata,
                                   options.group,
                                   "end_s",
                                   "window_end_s",
                                   "still_at_landmark",
                                   "issued",
                                   "synthetic_seed"};
  for (const H1Predictor& predictor : options.predictors) {
    columns.push_back(predictor.column);
    columns.push_back(predictor.landmark_column);
  }
  columns.insert(columns.end(), options.within.begin(), options.within.end());
  std::erase(columns, "");
  return columns;
}

}  // namespace tcert::study
