#pragma once
/// \file
/// The intervals of coefficients in tables, declared once for every fit.
///
/// `conf.low`, `conf.high`: Wald's, estimate -+ z SE, by the SE that stands beside it; broom's
/// conf.low of a `glm` is the profile's, here in `profile.low`, `profile.high`.
/// `t.low`, `t.high`, `t.p.value`: where clusters are named, by Student's t with clusters - 1
/// degrees of freedom; of a `glm` or Cox model as --inference says, with `t.std.error` and `t.df`.
/// NA for a single cluster. RATIO, RATIO.low, RATIO.high; RATIO.profile.low ...; RATIO.t.low ...:
/// exp of each of them, with RATIO odds.ratio or hazard.ratio.

#include <optional>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/basics/student_t.hpp>
#include <statistics/clusters/cluster_inference.hpp>
#include <statistics/logistic/logistic_profile.hpp>
#include <string>
#include <vector>

#include "reports/columns_of.hpp"

namespace tcert {

struct RatioName {
  std::string name;          ///< "odds.ratio".
  std::string heading;       ///< "odds ratio".
  std::string abbreviation;  ///< "OR".
};

[[nodiscard]] RatioName odds_ratio_name();
[[nodiscard]] RatioName hazard_ratio_name();

/// A log ratio with its Wald interval and one more.
struct LogRatio {
  std::optional<double> value;
  std::optional<statistics::Interval> wald;
  statistics::ProfileLimits other;
};

/// exp of the value and of all ends, missing where that is too large to be a number; `other` is
/// "profile", "t", or empty without such an interval.
[[nodiscard]] ColumnsOf<LogRatio> ratio_columns(const RatioName& ratio, const std::string& other);

/// profile.low, profile.high, profile.open.
[[nodiscard]] ColumnsOf<statistics::ProfileLimits> profile_columns();
[[nodiscard]] statistics::ProfileLimits limits_of(
    const std::optional<statistics::Interval>& interval);

/// t.std.error, t.df, t.p.value, t.low, t.high.
[[nodiscard]] ColumnsOf<statistics::ClusterT> inference_columns();

/// t.p.value, t.low, t.high; without the p for what has no test.
[[nodiscard]] ColumnsOf<statistics::ClusterT> t_columns(bool with_p = true);

/// statistic, df and a p.
[[nodiscard]] ColumnsOf<statistics::ChiSquareTest> chi_square_columns(
    const std::string& p_name = "p.value", const std::string& p_heading = "p");
[[nodiscard]] std::optional<double> statistic_of(
    const std::optional<statistics::ChiSquareTest>& test);
[[nodiscard]] std::optional<double> p_of(const std::optional<statistics::ChiSquareTest>& test);

/// A paired difference of two predictors' numbers.
struct Difference {
  std::string first;
  std::string second;
  std::optional<double> value;
  std::optional<double> std_error;
  std::optional<double> z;
  std::optional<double> p_value;
  std::optional<statistics::Interval> interval;
};

/// With 0 clusters there is nothing by t.
[[nodiscard]] Table difference_table(std::string title,
                                     const std::vector<Difference>& differences,
                                     std::size_t clusters,
                                     double level);

/// The interval within [0, 1], as that of a probability.
[[nodiscard]] statistics::ClusterT clipped(statistics::ClusterT by_t);

/// What the t columns are.
[[nodiscard]] std::string t_footnote(std::size_t clusters);
[[nodiscard]] std::string t_footnote(std::size_t clusters, statistics::ClusterInference by);

/// Few clusters are pointed to the t columns.
void point_to_t(statistics::Conditions& conditions);

}  // namespace tcert
