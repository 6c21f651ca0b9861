#pragma once
/// \file
/// The kinds of fit: each from a model frame to a report.

#include <statistics/model/formula.hpp>
#include <statistics/model/model_frame.hpp>
#include <string>
#include <vector>

#include "cli/runs/fit/fit.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

/// What a kind is given: the frame is without an error.
struct FitInput {
  const FitRequest& request;
  const statistics::Formula& formula;
  const table::DataTable& table;
  statistics::ModelFrame& frame;
  Progress& progress;
  const statistics::FrameOptions& options;  ///< Of the frame.
};

[[nodiscard]] FitReport fit_glm(const FitInput& from);
[[nodiscard]] FitReport fit_calibration(const FitInput& from);
/// Of Surv(): risks of a Cox model, out of fold.
[[nodiscard]] FitReport fit_time_calibration(const FitInput& from);
[[nodiscard]] FitReport fit_mixed_model(const FitInput& from);
[[nodiscard]] FitReport fit_linear_mixed_model(const FitInput& from);
[[nodiscard]] FitReport fit_cox_model(const FitInput& from);
[[nodiscard]] FitReport fit_fine_gray(const FitInput& from);
[[nodiscard]] FitReport fit_km(const FitInput& from);
[[nodiscard]] FitReport fit_roc(const FitInput& from);
[[nodiscard]] FitReport fit_concordance(const FitInput& from);

/// The word of an option among those allowed. \throws UsageError that names them.
[[nodiscard]] std::size_t choice(const std::string& option,
                                 const std::string& word,
                                 const std::vector<std::string>& words);

}  // namespace tcert::cli
