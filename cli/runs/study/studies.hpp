#pragma once
/// \file
/// The studies that `study` knows: which items each consists of, and what they come to.

#include <functional>
#include <string_view>
#include <vector>

#include "cli/runs/items.hpp"
#include "cli/runs/study/study.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

/// \pre every item is taken, in order, before the report.
struct StudyItems {
  std::vector<ItemSet> sets;
  TakeItem take;  ///< \throws table::RowError for a line that is not one of its item.
  std::function<FitReport()> report;
};

[[nodiscard]] StudyItems soundness_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems federation_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems coverage_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems inference_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems equivalence_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems hypotheses_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems advance_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems gate_coverage_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems ray_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems null_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems price_study(const StudyRequest& request, Progress& progress);
[[nodiscard]] StudyItems terrain_study(const StudyRequest& request, Progress& progress);

}  // namespace tcert::cli
