#pragma once
/// \file
/// The intervals of coefficients in tables, declared once for every fit.
///
/// `conf.low`, `conf.high`: Wald's, estimate -+ z SE, by the SE that stands beside it; broom's
/// conf.low of a `glm` is the profile's, here in `profile.low`, `profile.high`.
/// `t.low`, `t.high`, `t.p.value`: the same by Student's t with clusters - 1 degrees of freedom,
/// where clusters are named; NA for a single one.
/// RATIO, RATIO.low, RATIO.high; RATIO.profile.low ...; RATIO.t.low ...: exp of each of them, with
/// RATIO odds.ratio or hazard.ratio.

#include <optional>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

struct RatioName {
  std::string name;          ///< "odds.ratio".
  std::string heading;       ///< "odds ratio".
  std::string abbreviation;  ///< "OR".
};

[[nodiscard]] RatioName odds_ratio_name();
[[nodiscard]] RatioName hazard_ratio_name();

/// The ratio and its Wald interval; then one more interval each for `others`: "profile", "t".
[[nodiscard]] std::vector<Column> ratio_columns(const RatioName& ratio,
                                                const std::vector<std::string>& others);

/// exp of an end; missing if it is, or if it is too large to be a number.
[[nodiscard]] TableCell ratio_cell(const std::optional<double>& log_ratio);
/// exp of both ends.
void append_ratios(const std::optional<statistics::Interval>& log_ratio,
                   std::vector<TableCell>& cells);

/// profile.low, profile.high, profile.open.
[[nodiscard]] std::vector<Column> profile_columns();
void append_profile(const statistics::ProfileLimits& limits, std::vector<TableCell>& cells);
[[nodiscard]] statistics::ProfileLimits limits_of(
    const std::optional<statistics::Interval>& profile);

/// t.p.value, t.low, t.high; without the p for what has no test.
[[nodiscard]] std::vector<Column> t_columns(bool with_p = true);
void append_t(const statistics::ClusterT& by_t, std::vector<TableCell>& cells, bool with_p = true);

/// The interval within [0, 1], as that of a probability.
[[nodiscard]] statistics::ClusterT clipped(statistics::ClusterT by_t);

/// What the t columns are.
[[nodiscard]] std::string t_footnote(std::size_t clusters);

/// Few clusters are pointed to the t columns.
void point_to_t(statistics::Conditions& conditions);

void append_columns(const std::vector<Column>& more, std::vector<Column>& columns);

}  // namespace tcert
