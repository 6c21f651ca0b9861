#include "analysis/study/h1/panel_trials.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/study/h1/panel_times.hpp"
#include "analysis/study/trials/table_columns.hpp"

namespace tcert::study {
namespace {

/// Marks rows where `is_missing` holds and counts them.
template <class IsMissing>
std::size_t mark(const std::vector<std::size_t>& rows,
                 std::vector<bool>& complete,
                 const IsMissing& is_missing) {
  std::size_t missing = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (is_missing(rows[i])) {
      complete[i] = false;
      ++missing;
    }
  }
  return missing;
}

void list_missing(H1Panel& panel, const std::string& column, std::size_t missing) {
  if (missing > 0) {
    panel.missing.emplace_back(column, missing);
  }
}

}  // namespace

std::vector<std::size_t> trials_of_panel(const table::DataTable& table,
                                         const H1Options& options,
                                         const PanelColumns& columns,
                                         H1Panel& panel) {
  const std::vector<double> still = numbers_if_there(table, "still_at_landmark");
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (std::isnan(columns.success[row])) {
      continue;
    }
    if (panel.kind == H1PanelKind::landmark) {
      if (is_by(options.landmark_s, columns.end[row], options) ||
          is_by(options.landmark_s, columns.log_end[row], options)) {
        ++panel.ended_by_landmark;
        continue;
      }
      if (still[row] == 1.0) {
        ++panel.still_at_landmark;
        continue;
      }
    }
    rows.push_back(row);
  }
  panel.trials = rows.size();
  const auto is_known = [](double end) { return !std::isnan(end); };
  panel.ends_known = std::any_of(columns.end.begin(), columns.end.end(), is_known);
  return rows;
}

void count_window_ends(const table::DataTable& table,
                       const H1Options& options,
                       const PanelColumns& columns,
                       H1Panel& panel) {
  if (panel.kind != H1PanelKind::paper || table.find("window_end_s") == nullptr) {
    return;
  }
  const std::vector<double> window_end = numbers_in(table, "window_end_s");
  std::size_t ended = 0;
  std::size_t failures = 0;
  for (std::size_t row = 0; row < table.rows; ++row) {
    if (std::isnan(columns.success[row])) {
      continue;
    }
    const bool in_window = std::isnan(window_end[row])
                               ? !std::isnan(columns.log_end[row])
                               : is_by(window_end[row], columns.end[row], options);
    ended += in_window ? 1 : 0;
    failures += in_window && columns.success[row] == 0.0 ? 1 : 0;
  }
  panel.ended_in_window = ended;
  panel.failures_ended_in_window = failures;
}

std::vector<std::size_t> complete_trials(const std::vector<std::size_t>& rows,
                                         const H1Options& options,
                                         const PanelColumns& columns,
                                         H1Panel& panel) {
  std::vector<bool> complete(rows.size(), true);
  for (const std::vector<double>& predictor : columns.predictors) {
    panel.rows.emplace_back();
    panel.rows.back().missing =
        mark(rows, complete, [&](std::size_t row) { return std::isnan(predictor[row]); });
  }
  if (panel.has_time) {
    list_missing(panel, options.time, mark(rows, complete, [&](std::size_t row) {
                   return std::isnan(columns.time[row]);
                 }));
  }
  const auto mark_factor = [&](const std::optional<table::Factor>& factor,
                               const std::string& name) {
    if (factor) {
      list_missing(panel, name, mark(rows, complete, [&](std::size_t row) {
                     return factor->codes[row] == table::Factor::kMissing;
                   }));
    }
  };
  mark_factor(columns.cluster, options.cluster);
  mark_factor(columns.group, options.group);
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (complete[i]) {
      kept.push_back(rows[i]);
    }
  }
  panel.complete = kept.size();
  return kept;
}

}  // namespace tcert::study
