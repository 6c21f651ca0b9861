#include "reports/h2_notes.hpp"

#include <algorithm>
#include <statistics/basics/condition_groups.hpp>
#include <statistics/basics/few_clusters.hpp>

#include "reports/fit/cells.hpp"
#include "reports/h1_intervals.hpp"
#include "reports/h1_notes.hpp"
#include "reports/panel_rows.hpp"
#include "reports/table.hpp"

namespace tcert {
namespace {

std::string cluster_note(const study::H1Options& options) {
  return options.cluster.empty() ? "Trials are taken as independent: no cluster was named."
                                 : "Clusters: column '" + options.cluster +
                                       "'. Resamples draw whole clusters for all groups jointly. "
                                       "In simulated studies of 12 to 40 of them the "
                                       "test that AUCs are equal kept its level; that of C and the "
                                       "interactions were not tried.";
}

}  // namespace

std::vector<std::string> h2_level_notes(const study::H2Table& h2) {
  const study::H1Options& options = h2.options.trials;
  std::vector<std::string> notes;
  std::string limits;
  std::string sds;
  for (const study::H2Panel& panel : h2.panels) {
    notes.push_back(h1_panel_note(options, panel.trials, h2.panels.size() == 1));
    if (panel.missing > 0) {
      notes.push_back(panel.predictor + " is missing in " + std::to_string(panel.missing) +
                      " trials of the " + panel_name(h2, panel) + " panel.");
    }
    limits += (limits.empty() ? "" : ", ") + significant(panel.trials.limit_s, 6) + " s (" +
              panel_name(h2, panel) + ")";
    if (panel.sd) {
      sds += (sds.empty() ? "" : ", ") + significant(*panel.sd, kShownDigits) + " (" +
             panel_name(h2, panel) + ")";
    }
  }
  notes.push_back(cluster_note(options));
  notes.push_back(
      "AUC: Pr(a success outranks a failure) within the group, in the a-priori direction, ties one "
      "half. C: Pr(the better value goes with earlier egress) within the group. Intervals: " +
      interval_words(options.interval) + " of " + std::to_string(options.replicates) +
      " resamples, seed " + std::to_string(options.seed) + ".");
  notes.push_back(
      "Ratios are per standard deviation of the whole panel, " + sds +
      ", towards the better side; intervals by the jackknife of whole clusters and t, above 100 "
      "clusters by the robust variance and t. OR: of success, logistic. HR: of "
      "egress, Cox with "
      "Efron ties; at limit: failures stay at risk to " +
      limits + "; stratified: by '" + options.strata + "', failures censored.");
  if (h2.outcome_missing > 0) {
    notes.push_back(std::to_string(h2.outcome_missing) +
                    " trials without an outcome are left out.");
  }
  return notes;
}

std::vector<std::string> h2_equality_notes(const study::H2Table& h2) {
  return {
      "Equivalent: the 90 % interval of every pair's difference lies within -+" +
          significant(h2.options.margin, kShownDigits) +
          " (two one-sided tests at 5 % each, all pairs to pass, no correction). Smallest margin: "
          "at which they just would have.",
      "Margin with 80 % power: at which groups that are truly equal would be found so with "
      "probability 0.8 at least; by the largest standard error of a pair, SE (t(0.95) + t(1 - 0.1 "
      "/ pairs)). A smaller margin than that could hardly be shown here.",
      "Chi-squared: Wald's statistic that all are equal, with covariances by the jackknife of "
      "whole "
      "clusters; p as that of Hotelling's T squared, by F with df and clusters - df degrees of "
      "freedom. 'Not significant' is not equality.",
      "Max - min is descriptive: equal groups have one above 0 too. Expected: its mean when the "
      "groups' names are permuted within clusters (" +
          std::to_string(h2.options.permutations) + " permutations, seed " +
          std::to_string(h2.options.trials.seed) + "); p: of as large a one."};
}

}  // namespace tcert
