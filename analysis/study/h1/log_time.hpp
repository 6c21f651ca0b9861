#pragma once
/// \file
/// R2 of the traversal time, which the paper's abstract speaks of: a linear mixed model of log
/// time.

#include <Eigen/Core>
#include <cstddef>
#include <statistics/lmm/lmm.hpp>
#include <vector>

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Log times of successes in columns that models choose from.
struct LogTimes {
  Eigen::VectorXd log_time;
  Eigen::MatrixXd predictors;  ///< trials x predictors.
  table::Factor cluster;
};

/// The model of these columns, by the trials outside of cluster `without` (a code; none: -1).
[[nodiscard]] statistics::LmmFit log_time_fit(const LogTimes& times,
                                              const std::vector<std::size_t>& columns,
                                              double level,
                                              std::int64_t without = -1);

/// Marginal R2 of each model (a list of columns) without each cluster: models x clusters; NaN where
/// there is none.
[[nodiscard]] Eigen::MatrixXd r2_left_out(const LogTimes& times,
                                          const std::vector<std::vector<std::size_t>>& models);

/// Fills `log_time` of the panel's rows: of the trials that reach the goal, for the others have no
/// traversal time. Gains have an interval by the jackknife of whole clusters and t up to
/// statistics::kMostJackknifeClusters of them. Nothing without times, and where every trial is its
/// own cluster.
void add_log_time(const H1Data& data, const H1Options& options, H1Panel& panel);

}  // namespace tcert::study
