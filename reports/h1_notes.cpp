#include "reports/h1_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "analysis/basics/few_clusters.hpp"
#include "reports/h1_table.hpp"
#include "reports/table.hpp"

namespace tcert {
namespace {

std::string cluster_note(const H1Table& h1) {
  const std::string& cluster = h1.options.cluster;
  if (cluster.empty()) {
    return "Trials are taken as independent: no cluster was named.";
  }
  if (!h1.panels.front().has_clusters) {
    return "Trials are taken as independent, each its own cluster: the table has no column '" +
           cluster + "', or nothing in it.";
  }
  std::string note = "Clusters: column '" + cluster +
                     "'. Resamples draw whole clusters, the tests and robust variances use them";
  const bool few = std::any_of(h1.panels.begin(), h1.panels.end(), [](const H1Panel& panel) {
    return panel.clusters < kFewClusters;
  });
  return note + (few ? fmt::format("; with fewer than {} of them intervals tend to be too narrow.",
                                   kFewClusters)
                     : std::string("."));
}

/// `p` says what the p of a model is.
std::string model_note(std::string_view p) {
  return fmt::format(
      "'rivals together' is gained on by the predictor alone; 'rivals + ...' gains over the rivals "
      "together. Models are scored by their fixed part on the trials they were fitted to, and "
      "re-fitted in each resample; out of fold they score clusters that they have not seen. {}",
      p);
}

void add_conditions(const H1Table& h1, std::vector<std::string>& notes) {
  for (const H1Panel& panel : h1.panels) {
    for (const Condition& condition : panel.conditions) {
      notes.push_back(panel_name(h1, panel) + " panel: " + to_string(condition) + ".");
    }
    for (const H1Row& row : panel.rows) {
      for (const Condition& condition : row.conditions) {
        notes.push_back(panel_name(h1, panel) + " panel, " + row.name + ": " +
                        to_string(condition) + ".");
      }
    }
  }
}

}  // namespace

std::string h1_panel_note(const H1Options& options, const H1Panel& panel, bool only) {
  std::string note;
  if (panel.kind == H1PanelKind::paper) {
    note = std::string(only ? "Table" : "Paper panel") + ": features as they are, " +
           std::to_string(panel.trials) + " trials";
    if (panel.ended_in_window && panel.failures_ended_in_window) {
      note += "; " + std::to_string(*panel.ended_in_window) + " of them end inside their window (" +
              std::to_string(*panel.failures_ended_in_window) +
              " failures), which then contains the outcome";
    }
  } else {
    note = "Landmark panel: the time window alone, " + std::to_string(panel.trials) +
           " trials, times from " + significant(options.landmark_s, 4) +
           " s; excluded: " + std::to_string(panel.ended_by_landmark) +
           " that end before the landmark, " + std::to_string(panel.still_at_landmark) +
           " that stand still at it. Conclusions are drawn from this panel";
  }
  if (panel.complete < panel.trials) {
    note += "; " + std::to_string(panel.trials - panel.complete) +
            " without a complete row are left out of every line";
    for (const auto& [column, count] : panel.missing) {
      note += ", " + column + " missing in " + std::to_string(count);
    }
  }
  return note + ".";
}

std::vector<std::string> h1_success_notes(const H1Table& h1) {
  std::vector<std::string> notes;
  for (const H1Panel& panel : h1.panels) {
    notes.push_back(h1_panel_note(h1.options, panel, h1.panels.size() == 1));
  }
  notes.push_back(cluster_note(h1));
  notes.push_back(
      "AUC: Pr(a success outranks a failure) in the a-priori direction, ties one half. Gain: AUC "
      "of "
      "the predictor less that of the rival, on the same resamples (" +
      std::to_string(h1.options.replicates) + ", seed " + std::to_string(h1.options.seed) +
      "). p: clustered DeLong (Obuchowski 1997), two-sided; Holm over the rivals in AUC and in C.");
  notes.push_back(model_note(
      "Their p is the likelihood-ratio test of the logistic model, trials independent."));
  notes.push_back("Out of fold: mean within " + std::to_string(h1.options.folds) +
                  " folds of whole clusters, weighted by comparable pairs.");
  if (h1.outcome_missing > 0) {
    notes.push_back(std::to_string(h1.outcome_missing) +
                    " trials without an outcome are left out.");
  }
  add_conditions(h1, notes);
  return notes;
}

std::vector<std::string> h1_time_notes(const H1Table& h1) {
  const bool has_time = std::any_of(
      h1.panels.begin(), h1.panels.end(), [](const H1Panel& panel) { return panel.has_time; });
  if (!has_time) {
    return {"No C and no hazard ratios: column '" + h1.options.time +
            "' is not there, holds nothing or has a time that is not above 0."};
  }
  const std::string strata =
      h1.panels.front().has_strata
          ? "Stratified: by '" + h1.options.strata + "', failures censored."
          : "No stratified one: " +
                (h1.options.strata.empty()
                     ? std::string("no strata were named.")
                     : "the table has no column '" + h1.options.strata + "', or nothing in it.");
  std::string limits;
  for (const H1Panel& panel : h1.panels) {
    limits += (limits.empty() ? "" : ", ") + significant(panel.limit_s, 6) + " s (" +
              panel_name(h1, panel) + ")";
  }
  return {
      "C: Pr(the better value goes with earlier egress), Harrell's, failures censored when they "
      "fail; p by its clustered jackknife. Time is column '" +
          h1.options.time + "'; the event is egress.",
      "HR: hazard ratio of egress per standard deviation (column SD) towards the better side, Cox "
      "with Efron ties, cluster-robust; above 1 is sooner. At limit: failures stay at risk to " +
          limits + ". " + strata,
      model_note("For C the model is a Cox model; its p is the likelihood-ratio test, trials "
                 "independent. The HR of 'rivals + ...' is the predictor's, rivals held fixed."),
      "Clusters, panels and conditions: see the table of success."};
}

}  // namespace tcert
