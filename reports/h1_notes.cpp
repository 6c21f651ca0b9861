#include "reports/h1_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <statistics/basics/condition_groups.hpp>
#include <statistics/basics/few_clusters.hpp>
#include <string_view>

#include "reports/h1_intervals.hpp"
#include "reports/h1_table.hpp"
#include "reports/panel_rows.hpp"
#include "reports/table.hpp"

namespace tcert {
namespace {

std::string cluster_note(const study::H1Table& h1) {
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
  return note +
         ". From 6 of them on the intervals of AUC, C and gains and the tests of hazard and odds "
         "ratios "
         "kept their level in simulated studies; within strata they were not tried.";
}

/// `p` says what the p of a model is.
std::string model_note(std::string_view p) {
  return fmt::format(
      "'rivals together' is gained on by the predictor alone; 'rivals + ...' gains over the rivals "
      "together. Models are scored by their fixed part on the trials they were fitted to, and "
      "re-fitted in each resample; out of fold they score clusters that they have not seen. {}",
      p);
}

/// What the features of a landmark panel are of.
std::string window_words(const study::H1Panel& panel) {
  if (panel.not_of_window.empty()) {
    return "the time window alone, ";
  }
  std::string columns;
  for (const std::string& column : panel.not_of_window) {
    columns += (columns.empty() ? "'" : ", '") + column + "'";
  }
  return columns + " as in the other panel, for the table has no column of the time window alone, ";
}

}  // namespace

std::string h1_panel_note(const study::H1Options& options, const study::H1Panel& panel, bool only) {
  std::string note;
  if (panel.kind == study::H1PanelKind::paper) {
    note = std::string(only ? "Table" : "Paper panel") + ": features as they are, " +
           std::to_string(panel.trials) + " trials";
    if (panel.ended_in_window && panel.failures_ended_in_window) {
      note += "; " + std::to_string(*panel.ended_in_window) + " of them end inside their window (" +
              std::to_string(*panel.failures_ended_in_window) +
              " failures), which then contains the outcome";
    }
  } else {
    const std::string landmark = significant(options.landmark_s, 4) + " s";
    note =
        "Landmark panel: " + window_words(panel) + std::to_string(panel.trials) +
        " trials, times from " + landmark + "; excluded: " +
        (panel.ends_known
             ? std::to_string(panel.ended_by_landmark) + " that end before the landmark, "
             : "none for having ended before the landmark, as the table does not "
               "say when trials end, ") +
        std::to_string(panel.still_at_landmark) + " that stand still at it. " +
        (panel.not_of_window.empty()
             ? "Conclusions are drawn from this panel"
             : "Conclusions are drawn from this panel if those columns are known by " + landmark);
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

std::vector<std::string> h1_success_notes(const study::H1Table& h1) {
  std::vector<std::string> notes;
  for (const study::H1Panel& panel : h1.panels) {
    notes.push_back(h1_panel_note(h1.options, panel, h1.panels.size() == 1));
  }
  notes.push_back(cluster_note(h1));
  notes.push_back(
      "AUC: Pr(a success outranks a failure) in the a-priori direction, ties one half. Gain: AUC "
      "of "
      "the predictor less that of the rival, on the same resamples (" +
      std::to_string(h1.options.replicates) + ", seed " + std::to_string(h1.options.seed) +
      "). Intervals: " + interval_words(h1.options.interval) +
      "; the others are in h1_intervals. p: jackknife of whole clusters and Student's t, "
      "two-sided; Holm "
      "over the rivals in AUC and in C.");
  notes.push_back(
      model_note("Their p is Wald's test of the predictor added, by the jackknife of whole "
                 "clusters and t; the "
                 "likelihood ratio, trials independent, is in h1_closed_form."));
  notes.push_back(
      "Within folds: mean within " + std::to_string(h1.options.folds) +
      " folds of whole clusters, weighted by comparable pairs. A predictor is scored as "
      "it is, so that nothing of it is out of fold; models are fitted to the other folds.");
  if (h1.outcome_missing > 0) {
    notes.push_back(std::to_string(h1.outcome_missing) +
                    " trials without an outcome are left out.");
  }
  return notes;
}

std::vector<std::string> h1_time_notes(const study::H1Table& h1) {
  const bool has_time = std::any_of(h1.panels.begin(),
                                    h1.panels.end(),
                                    [](const study::H1Panel& panel) { return panel.has_time; });
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
  for (const study::H1Panel& panel : h1.panels) {
    limits += (limits.empty() ? "" : ", ") + significant(panel.limit_s, 6) + " s (" +
              panel_name(h1, panel) + ")";
  }
  return {
      "C: Pr(the better value goes with earlier egress), Harrell's, failures censored when they "
      "fail. Time is column '" +
          h1.options.time + "'; the event is egress.",
      "C, failures at limit: the same where failures stay at risk to the limit, with the interval "
      "of "
      "the jackknife of whole clusters and t.",
      "HR: hazard ratio of egress per standard deviation (column SD) towards the better side, Cox "
      "with Efron ties; interval by the jackknife of whole clusters and t, above 100 clusters by "
      "the "
      "robust variance and t; above 1 is sooner. At limit: failures stay at risk to " +
          limits + ". " + strata,
      model_note("For C the model is a Cox model; its p is made as that of success. The HR of "
                 "'rivals + ...' is the predictor's, rivals held fixed."),
      "Clusters and panels: see the table of success."};
}

}  // namespace tcert
