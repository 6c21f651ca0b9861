#pragma once
/// \file
/// Areas under ROC curves, their differences, thresholds and points as tables.

#include <optional>
#include <statistics/roc/roc.hpp>
#include <statistics/roc/roc_curve.hpp>
#include <string>
#include <vector>

#include "reports/fit/fit_report.hpp"

namespace tcert {

/// Part of an axis that a partial area is taken over.
struct PartialRange {
  statistics::RocFocus focus = statistics::RocFocus::specificity;
  double low = 0.9;
  double high = 1.0;
};

/// One name and one curve a marker of `joint`.
[[nodiscard]] FitReport roc_report(const std::vector<std::string>& names,
                                   const statistics::JointAuc& joint,
                                   const std::vector<statistics::RocCurve>& curves,
                                   const std::optional<PartialRange>& partial);

}  // namespace tcert
