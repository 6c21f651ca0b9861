#pragma once
/// \file
/// AUC and C over pairs of trials of one stratum: what a predictor tells where what is fixed before
/// a trial (its algorithm, its lighting) is the same for both.

#include <optional>
#include <statistics/concordance/concordance.hpp>
#include <statistics/resampling/statistic.hpp>
#include <vector>

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Of every predictor, with clustered jackknife variances and differences. For outcomes 0 and 1 C
/// is the AUC. As R's `concordance(outcome ~ x + strata(s), cluster = day)`.
struct WithinScores {
  statistics::ConcordanceResult auc;
  std::optional<statistics::ConcordanceResult> c;  ///< Empty without times.
};

/// On those of `rows` whose stratum is known. Empty without strata, or if no such row has one.
[[nodiscard]] std::optional<WithinScores> within_scores(const H1Data& data,
                                                        const std::vector<std::size_t>& rows,
                                                        double level);

/// The AUC of every predictor, then C of each if there are times, as functions of all rows of the
/// panel; NaN where a resample has no pair within a stratum. \pre a row has a stratum.
[[nodiscard]] statistics::Statistic within_statistic(const H1Data& data);

/// Fills `within` of the panel, and the closed forms of `within` of its rows, if it has any.
void add_within_strata(const H1Data& data, double level, H1Panel& panel);

}  // namespace tcert::study
