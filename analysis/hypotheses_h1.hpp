#pragma once
/// \file
/// H1: the early certificate margin tells successes from failures better than contact heuristics.

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/feature_table.hpp"
#include "analysis/roc.hpp"

namespace tcert {

/// The early window may contain the outcome, so the test is made twice.
enum class H1PanelKind {
  paper,     ///< Features of the early window as configured, all trials.
  landmark,  ///< Features of the time window; only trials that are still running when it closes.
};

[[nodiscard]] std::string_view to_string(H1PanelKind kind) noexcept;

/// One predictor, on the rows where all predictors of the panel are known.
struct H1Row {
  std::string_view predictor;  ///< Name of its column in the feature table.
  HigherMeans higher = HigherMeans::success;
  std::size_t missing = 0;               ///< Trials of the panel without this predictor.
  AucEstimate auc;                       ///< Plain DeLong: trials of one day taken as independent.
  std::optional<AucDifference> tc_gain;  ///< AUC of the certificate minus this one's; rivals only.
};

/// Where the certificate feature of a panel lies, for one outcome.
struct TcDistribution {
  bool success = false;
  std::size_t trials = 0;
  std::size_t missing = 0;
  std::size_t negative = 0;  ///< Below 0, of those that are not missing.
  std::optional<double> p10, p50, p90;
};

struct H1Panel {
  H1PanelKind kind = H1PanelKind::paper;
  std::size_t trials = 0;    ///< With a known outcome, after the exclusions below.
  std::size_t complete = 0;  ///< Of those, with all predictors known: the rows' n.

  // Landmark panel: what was excluded, in this order.
  std::size_t ended_by_landmark = 0;
  std::size_t still_at_landmark = 0;

  // Paper panel: trials that are over before their window is, which then contains the outcome.
  std::size_t ended_in_window = 0;
  std::size_t failures_ended_in_window = 0;

  std::vector<H1Row> rows;  ///< The certificate first, then contacts, dwell, bend variance.
  std::vector<TcDistribution> distribution;  ///< Successes, failures.
};

/// How often a certificate was issued, for one outcome.
struct IssuedCount {
  bool success = false;
  std::size_t trials = 0;
  std::size_t issued = 0;
};

struct H1Table {
  std::size_t trials = 0;           ///< Rows of the feature table.
  std::size_t outcome_missing = 0;  ///< Of those, left out everywhere.
  std::vector<IssuedCount> issued;  ///< Successes, failures.
  std::vector<H1Panel> panels;      ///< Paper, landmark. Conclusions are drawn from the latter.
};

struct H1Options {
  double landmark_s = 15.0;  ///< The time window that the features were made with.
  double level = 0.95;       ///< Of the intervals, in (0, 1).
};

/// A trial ends at its time_s, or with its log where that is not given; one of which neither is
/// known is taken to run on. A log that ends by the landmark excludes its trial from that panel
/// too. A higher certificate speaks for success; more contacts, dwell and variance speak for
/// failure, whatever the data say. \throws std::invalid_argument if `level` is out of range.
/// O(trials log trials).
[[nodiscard]] H1Table hypothesis_h1(std::span<const FeatureRow> trials,
                                    const H1Options& options = {});

}  // namespace tcert
