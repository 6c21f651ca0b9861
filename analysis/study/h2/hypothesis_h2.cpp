#include "analysis/study/h2/hypothesis_h2.hpp"

#include <algorithm>
#include <cmath>
#include <statistics/basics/standard_deviation.hpp>
#include <statistics/concordance/concordance_statistic.hpp>
#include <statistics/equivalence/scores_by_group.hpp>
#include <statistics/equivalence/statistic_by_group.hpp>
#include <statistics/model/factor_levels.hpp>
#include <statistics/roc/auc_statistic.hpp>
#include <stdexcept>
#include <utility>

#include "analysis/study/h1/h1_score.hpp"
#include "analysis/study/h1/hazard_ratio.hpp"
#include "analysis/study/h1/panel_data.hpp"
#include "analysis/study/h1/within_strata.hpp"
#include "analysis/study/h2/group_models.hpp"
#include "analysis/study/h2/withhold_groups.hpp"

namespace tcert::study {
namespace {

/// Streams of the seed; panels, resamples and permutations must not share draws.
constexpr std::uint32_t kH2Stream = 0x48320000;  // "H2"
constexpr std::uint32_t kPanelStreams = 16;

/// AUC, and C if there are times, of the predictor on all rows.
statistics::Statistic statistic_of_all(const H1Data& data) {
  const statistics::Score score = data.score(0);
  statistics::Statistic auc = statistics::auc_statistic({&score, 1}, data.success);
  if (!data.censored) {
    return auc;
  }
  const statistics::Predictor timed = data.timed(0);
  return statistics::joined(
      {std::move(auc), statistics::concordance_statistic(*data.censored, {&timed, 1})});
}

void count_levels(const H1Data& data, H2Panel& panel) {
  const auto rows_of = statistics::rows_of_levels(*data.group);
  for (std::size_t g = 0; g < rows_of.size(); ++g) {
    H2Level level;
    level.name = data.group->levels[g];
    level.trials = rows_of[g].size();
    for (const std::size_t row : rows_of[g]) {
      level.successes += data.success[row];
    }
    level.clusters = statistics::on_rows(data.cluster, rows_of[g]).levels.size();
    panel.levels.push_back(std::move(level));
  }
}

void take(const statistics::GroupScore& score,
          const std::string& quantity,
          H1Score& to,
          H2Level& level) {
  to.value = score.value;
  to.closed_form = score.interval;
  to.std_error = score.standard_error;
  for (statistics::Condition condition : score.conditions) {
    condition.detail = quantity + (condition.detail.empty() ? "" : ": " + condition.detail);
    level.conditions.push_back(std::move(condition));
  }
}

void bootstrap_levels(const H1Data& data,
                      const statistics::Statistic& scores,
                      const H2Options& options,
                      const Watch& watch,
                      H2Panel& panel) {
  const statistics::ResamplingPlan plan =
      statistics::ResamplingPlan::of_clusters(data.cluster.codes);
  statistics::BootstrapOptions bootstrap_options;
  bootstrap_options.replicates = options.trials.replicates;
  bootstrap_options.seed = options.trials.seed;
  bootstrap_options.analysis =
      kH2Stream + kPanelStreams * static_cast<std::uint32_t>(panel.trials.kind);
  bootstrap_options.advance = watch.on_advance;
  watch.begin(resamples_of(panel.trials.kind), options.trials.replicates);
  const bool has_strata = !panel.trials.within.columns.empty();
  const statistics::Statistic each =
      has_strata ? statistics::joined({scores, within_statistic(data)}) : scores;
  const statistics::BootstrapResult result =
      statistics::bootstrap(statistics::by_group(each, *data.group), plan, bootstrap_options);
  for (std::size_t g = 0; g < panel.levels.size(); ++g) {
    H2Level& level = panel.levels[g];
    std::size_t value = g * each.values;
    const auto take_next = [&](const std::string& quantity, H1Score& to) {
      // The clusters that a group is made of, which may be few of those that are drawn.
      take_score(result, value++, options.trials, quantity, to, level.conditions, level.clusters);
    };
    take_next("AUC", level.auc);
    if (data.censored) {
      take_next("C", level.c);
    }
    if (has_strata) {
      take_next("AUC within strata", level.auc_within);
      if (data.censored) {
        take_next("C within strata", level.c_within);
      }
    }
  }
}

std::optional<H2Equality> equality(std::optional<statistics::GroupEstimates> by_level,
                                   const H1Data& data,
                                   const statistics::Statistic& scores,
                                   std::size_t value,
                                   const H2Options& options,
                                   const Watch& watch,
                                   H2Panel& panel) {
  if (!by_level) {
    return std::nullopt;
  }
  H2Equality result;
  result.groups = std::move(*by_level);
  statistics::EquivalenceOptions equivalence_options;
  equivalence_options.margin = options.margin;
  result.tests = statistics::equivalence(result.groups, equivalence_options);
  for (statistics::Condition condition : result.tests.conditions) {
    condition.detail = value == 0 ? "AUC" : "C";
    panel.conditions.push_back(std::move(condition));
  }
  statistics::PermutationOptions permutation;
  permutation.permutations = options.permutations;
  permutation.seed = options.trials.seed;
  permutation.analysis = kH2Stream + kPanelStreams * static_cast<std::uint32_t>(panel.trials.kind) +
                         1 + static_cast<std::uint32_t>(value);
  permutation.advance = watch.on_advance;
  watch.begin(std::string(to_string(panel.trials.kind)) + " panel, permutations of " +
                  (value == 0 ? "AUC" : "C"),
              options.permutations);
  result.range = statistics::range_under_equality(
      data.group->codes,
      data.cluster.codes,
      statistics::range_of(scores, value, data.group->levels.size()),
      permutation);
  return result;
}

void take(const statistics::ConcordanceEstimate& estimate, H1Score& to) {
  to.value = estimate.c;
  to.closed_form = estimate.interval;
  to.std_error = estimate.std_error;
}

void score_within_strata(const H1Data& data, double level, H2Panel& panel) {
  add_within_strata(data, level, panel.trials);
  const auto rows_of = statistics::rows_of_levels(*data.group);
  for (std::size_t g = 0; g < panel.levels.size(); ++g) {
    const auto scores = within_scores(data, rows_of[g], level);
    if (!scores) {
      continue;
    }
    take(scores->auc.estimates.front(), panel.levels[g].auc_within);
    if (scores->c) {
      take(scores->c->estimates.front(), panel.levels[g].c_within);
    }
  }
}

void score_levels(const H1Data& data,
                  const H2Options& options,
                  const Watch& watch,
                  H2Panel& panel) {
  const double level = options.trials.level;
  const statistics::Statistic scores = statistic_of_all(data);
  const std::vector<statistics::GroupScore> auc =
      statistics::auc_by_group(data.score(0), data.success, *data.group, data.cluster.codes, level);
  for (std::size_t g = 0; g < panel.levels.size(); ++g) {
    take(auc[g], "AUC", panel.levels[g].auc, panel.levels[g]);
  }
  const auto jointly = [&](std::size_t value) {
    return statistics::jackknife_by_group(scores, value, *data.group, data.cluster.codes);
  };
  panel.auc = equality(jointly(0), data, scores, 0, options, watch, panel);
  if (data.censored) {
    const std::vector<statistics::GroupScore> c = statistics::concordance_by_group(
        *data.censored, data.timed(0), *data.group, data.cluster, level);
    for (std::size_t g = 0; g < panel.levels.size(); ++g) {
      take(c[g], "C", panel.levels[g].c, panel.levels[g]);
    }
    panel.c = equality(jointly(1), data, scores, 1, options, watch, panel);
  }
  score_within_strata(data, level, panel);
  bootstrap_levels(data, scores, options, watch, panel);
}

H2Panel panel_of(const table::DataTable& table,
                 const H2Options& options,
                 const Watch& watch,
                 H1PanelKind kind) {
  H2Panel panel;
  panel.trials.kind = kind;
  const H1Data data = panel_data(table, options.trials, panel.trials);
  panel.missing = panel.trials.rows.front().missing;
  panel.trials.rows.clear();
  panel.predictor = data.names.front();
  panel.higher = data.higher.front();
  if (!can_be_scored(panel.trials)) {
    return panel;
  }
  if (data.group->levels.size() < 2) {
    panel.conditions.push_back({statistics::ConditionKind::one_group,
                                statistics::ConditionSeverity::error,
                                options.trials.group,
                                ""});
    return panel;
  }
  panel.sd = statistics::standard_deviation(data.predictors.front());
  count_levels(data, panel);
  score_levels(data, options, watch, panel);
  add_group_effects(data, options.trials.level, panel);
  add_interactions(data, options.trials.cluster, panel);
  withhold_if_few(options, panel);
  return panel;
}

void validate(const H2Options& options) {
  if (options.trials.predictors.size() != 1 || options.trials.group.empty()) {
    throw std::invalid_argument("H2 needs one predictor and a group");
  }
  if (!(options.trials.level > 0.0 && options.trials.level < 1.0)) {
    throw std::invalid_argument("H2: the level must be in (0, 1)");
  }
  if (options.trials.replicates < 1 || options.permutations < 1 || !(options.margin > 0.0)) {
    throw std::invalid_argument("H2 needs a replicate, a permutation and a margin above 0");
  }
}

}  // namespace

H2Table hypothesis_h2(const table::DataTable& table, const H2Options& options, const Watch& watch) {
  validate(options);
  H2Table h2;
  h2.options = options;
  h2.trials = table.rows;
  h2.panels.push_back(panel_of(table, options, watch, H1PanelKind::paper));
  if (has_landmark(table, options.trials)) {
    h2.panels.push_back(panel_of(table, options, watch, H1PanelKind::landmark));
  }
  h2.outcome_missing = table.rows - h2.panels.front().trials.trials;
  return h2;
}

std::vector<std::string> columns_of(const H2Options& options) { return columns_of(options.trials); }

}  // namespace tcert::study
