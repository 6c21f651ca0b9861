#pragma once
/// \file
/// The predictors of a frame one by one, and bootstrap intervals of a number for each of them and
/// for their differences.

#include <statistics/resampling/statistic.hpp>
#include <string>
#include <vector>

#include "cli/runs/fit/fit_input.hpp"

namespace tcert::cli {

struct FrameColumns {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
};

/// The design's columns but the intercept. \throws FormulaError if there is none.
[[nodiscard]] FrameColumns predictor_columns(const statistics::ModelFrame& frame);

/// \throws UsageError if the rows have case weights, or `plain` is false: a resample is one of
/// rows.
void require_plain_bootstrap(const FitInput& from, bool plain);

/// Adds a table `bootstrap`: per predictor, then per pair of them, the value, its bias, standard
/// error and BCa, percentile and basic intervals. Whole clusters are drawn where there are any.
void add_bootstrap(const FitInput& from,
                   const std::vector<std::string>& names,
                   const statistics::Statistic& statistic,
                   FitReport& report);

}  // namespace tcert::cli
