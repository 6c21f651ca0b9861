#pragma once
/// \file
/// The agreement of probabilities with outcomes as tables.

#include <cstddef>
#include <optional>
#include <statistics/calibration/calibration.hpp>
#include <string>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Where the probabilities came from, one each a row.
struct CalibrationSource {
  std::vector<std::size_t> rows;  ///< Of the table, counted from 0.
  std::vector<double> outcome;
  std::vector<double> probability;  ///< NaN where a fold has no fit.
  std::vector<std::size_t> fold;    ///< From 1; empty if the probabilities were given.
  std::size_t folds = 0;            ///< 0 if the probabilities were given.
  std::string predicted;            ///< The column of given probabilities.
};

[[nodiscard]] FitReport calibration_report(const statistics::ModelCalibration& calibration,
                                           const CalibrationSource& source,
                                           double level);

}  // namespace tcert
