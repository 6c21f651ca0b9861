#pragma once
/// \file
/// The studies that `study` knows, each from a request to a report.

#include "cli/runs/study/study.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

[[nodiscard]] FitReport soundness_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] FitReport coverage_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] FitReport equivalence_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] FitReport gate_coverage_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] FitReport ray_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] FitReport null_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] FitReport terrain_study(const StudyRequest& request, Progress& progress);

}  // namespace tcert::cli
