#pragma once
/// \file
/// The figures of H1 from its tables. Empty if the tables have nothing to draw.

#include <optional>
#include <string>

#include "reports/figure/figure.hpp"
#include "reports/table.hpp"

namespace tcert {

/// ROC curves of all rows, a panel for each panel of H1, from h1_roc. Points within a straight
/// stretch of a curve are left out.
[[nodiscard]] std::optional<Figure> roc_figure(const Table& h1_roc);

/// Cumulative incidence of egress by quartile of `predictor` (a column; may be empty), with numbers
/// at risk, from h1_incidence_curve.
[[nodiscard]] std::optional<Figure> incidence_figure(const Table& h1_incidence_curve,
                                                     const std::string& predictor);

/// Observed share of successes against the out-of-fold probability, from h1_calibration.
[[nodiscard]] std::optional<Figure> calibration_figure(const Table& h1_calibration);

/// Odds and hazard ratios per standard deviation with their intervals, of the last panel (landmark,
/// where there is one), from h1_mixed and h1_time.
[[nodiscard]] std::optional<Figure> forest_figure(const Table& h1_mixed, const Table& h1_time);

/// AUC and C over all pairs of trials beside those within strata, of every predictor, of the last
/// panel: from h1, h1_within, h1_time and h1_time_within.
[[nodiscard]] std::optional<Figure> within_figure(const Table& h1,
                                                  const Table& h1_within,
                                                  const Table& h1_time,
                                                  const Table& h1_time_within);

/// The gain of AUC of the predictor under test over each rival without each cluster in turn, in the
/// order of the clusters, beside the gain of all trials; of the last panel, from h1 and h1_left_out.
[[nodiscard]] std::optional<Figure> left_out_figure(const Table& h1, const Table& h1_left_out);

}  // namespace tcert
