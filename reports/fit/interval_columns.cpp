#include "reports/fit/interval_columns.hpp"

#include <algorithm>
#include <cmath>

namespace tcert {
namespace {

std::string open_words(const statistics::ProfileLimits& limits) {
  if (limits.open_low && limits.open_high) {
    return "no limits";
  }
  return limits.open_low ? "no lower limit" : limits.open_high ? "no upper limit" : "";
}

/// Missing if it is, or if it is too large to be a number.
std::optional<double> exp_of(const std::optional<double>& log_ratio) {
  return log_ratio ? std::optional(std::exp(*log_ratio)) : std::nullopt;
}

}  // namespace

RatioName odds_ratio_name() { return {"odds.ratio", "odds ratio", "OR"}; }

RatioName hazard_ratio_name() { return {"hazard.ratio", "hazard ratio", "HR"}; }

ColumnsOf<LogRatio> ratio_columns(const RatioName& ratio, const std::string& other) {
  const std::string& name = ratio.name;
  const std::string& heading = ratio.abbreviation;
  ColumnsOf<LogRatio> columns;
  columns.number(name, ratio.heading, [](auto& r) { return exp_of(r.value); })
      .number(
          name + ".low", heading + " low", [](auto& r) { return exp_of(limits_of(r.wald).low); })
      .number(name + ".high", heading + " high", [](auto& r) {
        return exp_of(limits_of(r.wald).high);
      });
  if (!other.empty()) {
    columns
        .number(name + '.' + other + ".low",
                heading + ' ' + other + " low",
                [](auto& r) { return exp_of(r.other.low); })
        .number(name + '.' + other + ".high", heading + ' ' + other + " high", [](auto& r) {
          return exp_of(r.other.high);
        });
  }
  return columns;
}

ColumnsOf<statistics::ProfileLimits> profile_columns() {
  using Limits = statistics::ProfileLimits;
  return ColumnsOf<Limits>()
      .number("profile.low", "profile low", &Limits::low)
      .number("profile.high", "profile high", &Limits::high)
      .text("profile.open", "open end", open_words);
}

statistics::ProfileLimits limits_of(const std::optional<statistics::Interval>& interval) {
  statistics::ProfileLimits limits;
  if (interval) {
    limits.low = interval->low;
    limits.high = interval->high;
  }
  return limits;
}

ColumnsOf<statistics::ClusterT> inference_columns() {
  using ByT = statistics::ClusterT;
  ColumnsOf<ByT> columns;
  columns.number("t.std.error", "t SE", &ByT::standard_error).number("t.df", "t df", &ByT::df);
  return columns.part(t_columns(), [](auto& r) { return &r; });
}

ColumnsOf<statistics::ClusterT> t_columns(bool with_p) {
  using ByT = statistics::ClusterT;
  ColumnsOf<ByT> columns;
  if (with_p) {
    columns.p("t.p.value", "t p", &ByT::p_value);
  }
  columns.ends({"t.low", "t low"}, {"t.high", "t high"}, &ByT::interval);
  return columns;
}

ColumnsOf<statistics::ChiSquareTest> chi_square_columns(const std::string& p_name,
                                                        const std::string& p_heading) {
  using Test = statistics::ChiSquareTest;
  return ColumnsOf<Test>()
      .number("statistic", "chi-squared", &Test::statistic)
      .integer("df", "df", &Test::df)
      .p(p_name, p_heading, &Test::p_value);
}

std::optional<double> statistic_of(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? std::optional(test->statistic) : std::nullopt;
}

std::optional<double> p_of(const std::optional<statistics::ChiSquareTest>& test) {
  return test ? std::optional(test->p_value) : std::nullopt;
}

Table difference_table(std::string title,
                       const std::vector<Difference>& differences,
                       std::size_t clusters,
                       double level) {
  ColumnsOf<Difference> columns;
  columns.text("first", "first", &Difference::first)
      .text("second", "second", &Difference::second)
      .number("estimate", "difference", &Difference::value)
      .number("std.error", "SE", &Difference::std_error)
      .number("statistic", "z", &Difference::z)
      .p("p.value", "p", &Difference::p_value)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, &Difference::interval);
  if (clusters > 0) {
    columns.part(t_columns(), [&](auto& r) {
      return std::optional(statistics::by_cluster_t(r.value, r.std_error, r.z, clusters, level));
    });
  }
  return columns.table("differences", std::move(title), differences);
}

statistics::ClusterT clipped(statistics::ClusterT by_t) {
  if (by_t.interval) {
    by_t.interval->low = std::max(0.0, by_t.interval->low);
    by_t.interval->high = std::min(1.0, by_t.interval->high);
  }
  return by_t;
}

std::string t_footnote(std::size_t clusters) {
  if (clusters < 2) {
    return "t: nothing, for there is a single cluster.";
  }
  return "t: by Student's t with clusters - 1 = " + std::to_string(clusters - 1) +
         " degrees of freedom; the other intervals and p are by the normal distribution, as R has "
         "them.";
}

std::string t_footnote(std::size_t clusters, statistics::ClusterInference by) {
  if (clusters < 2) {
    return t_footnote(clusters);
  }
  const std::string degrees =
      "Student's t with clusters - 1 = " + std::to_string(clusters - 1) + " degrees of freedom";
  std::string words;
  switch (by) {
    case statistics::ClusterInference::cr1:
      words = "the sandwich times G/(G - 1) (CR1), " + degrees;
      break;
    case statistics::ClusterInference::cr2:
      words =
          "the sandwich of Bell and McCaffrey (CR2), Student's t with Satterthwaite's degrees of "
          "freedom";
      break;
    case statistics::ClusterInference::jackknife:
      words = "the jackknife of whole clusters (CV3), " + degrees;
      break;
    case statistics::ClusterInference::wild:
      words =
          "a wild bootstrap of the clusters' scores under the hypothesis, its interval what is not "
          "rejected; SE by CR1";
      break;
  }
  return "t: by " + words +
         "; the other intervals and p are by the normal distribution, as R has " +
         "them, and too sure of themselves with few clusters.";
}

void point_to_t(statistics::Conditions& conditions) {
  for (statistics::Condition& condition : conditions) {
    if (condition.kind == statistics::ConditionKind::few_clusters && condition.advice.empty()) {
      condition.advice =
          condition.severity == statistics::ConditionSeverity::note
              ? "intervals by the normal distribution tend to be too narrow; those by t stand "
                "beside them"
              : "intervals and p by the normal distribution are not to be believed; read those by "
                "t, with care";
    }
  }
}

}  // namespace tcert
