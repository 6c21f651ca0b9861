#pragma once
/// \file
/// Figures of TC_early and the outcome, of the trials that H1's conclusions are drawn from.

#include <optional>
#include <string>

#include "analysis/study/early/early_trials.hpp"
#include "reports/figure/figure.hpp"

namespace tcert {

/// Share of successes by quantile of TC_early with Wilson's intervals, and that of all trials.
[[nodiscard]] std::optional<Figure> success_by_quantile_figure(
    const study::EarlyTrials& trials, const std::optional<SyntheticLabel>& synthetic);

/// Histograms of TC_early of both outcomes, each of its own trials, with medians and quartiles.
/// Empty unless both occur.
[[nodiscard]] std::optional<Figure> early_by_outcome_figure(
    const study::EarlyTrials& trials, const std::optional<SyntheticLabel>& synthetic);

/// AUC of TC_early within each day and over all of them. Empty without days.
[[nodiscard]] std::optional<Figure> auc_by_day_figure(
    const study::EarlyTrials& trials, const std::optional<SyntheticLabel>& synthetic);

/// Successes kept and failures stopped by threshold on TC_early, and the threshold that keeps 95 %
/// of the successes. Empty unless both outcomes occur.
[[nodiscard]] std::optional<Figure> operating_point_figure(
    const study::EarlyTrials& trials, const std::optional<SyntheticLabel>& synthetic);

/// Which trials these are, for a caption: one sentence. Internal to reports/figure.
[[nodiscard]] std::string early_trials_text(const study::EarlyTrials& trials);

}  // namespace tcert
