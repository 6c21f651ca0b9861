#include "analysis/study/early/early_trials.hpp"

#include <algorithm>
#include <utility>

#include "analysis/study/h1/panel_columns.hpp"
#include "analysis/study/h1/panel_data.hpp"
#include "analysis/study/trials/table_columns.hpp"

namespace tcert::study {

std::vector<double> EarlyTrials::sorted_values(bool of_successes) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < size(); ++i) {
    if ((success[i] != 0) == of_successes) {
      values.push_back(tc_early_m[i]);
    }
  }
  std::sort(values.begin(), values.end());
  return values;
}

std::optional<EarlyTrials> early_trials(const table::DataTable& features, double landmark_s) {
  H1Options options;
  options.predictors.resize(1);
  options.landmark_s = landmark_s;
  if (!is_there(features, options.success) ||
      !is_there(features, options.predictors.front().column)) {
    return std::nullopt;
  }
  H1Panel panel;
  panel.kind = has_landmark(features, options) ? H1PanelKind::landmark : H1PanelKind::paper;
  H1Data data = panel_data(features, options, panel);
  if (data.rows() == 0) {
    return std::nullopt;
  }
  EarlyTrials trials;
  trials.kind = panel.kind;
  trials.tc_early_m = std::move(data.predictors.front());
  trials.success = std::move(data.success);
  trials.day = std::move(data.cluster);
  trials.has_days = panel.has_clusters;
  trials.landmark_s = landmark_s;
  return trials;
}

}  // namespace tcert::study
