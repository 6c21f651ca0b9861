#include "reports/fit/survival_report.hpp"

#include <algorithm>

#include "reports/columns_of.hpp"
#include "reports/fit/matrix_table.hpp"
#include "reports/fit/shown_times.hpp"

namespace tcert {
namespace {

/// Of every group; all times if there is no event.
std::vector<double> event_times(const std::vector<statistics::SurvivalCurve>& curves) {
  std::vector<double> times;
  std::vector<double> all;
  for (const statistics::SurvivalCurve& curve : curves) {
    for (const statistics::SurvivalPoint& point : curve.points) {
      all.push_back(point.time);
      if (point.events > 0.0) {
        times.push_back(point.time);
      }
    }
  }
  return times.empty() ? all : times;
}

Table group_table(const std::vector<statistics::SurvivalCurve>& curves,
                  const SurvivalReportOptions& options) {
  struct Group {
    const statistics::SurvivalCurve& curve;
    statistics::SurvivalQuantile median;
    statistics::RestrictedMean mean;
  };
  const auto columns =
      ColumnsOf<Group>()
          .text("strata", "group", [](auto& r) { return group_name(r.curve.group); })
          .integer("records", "rows", [](auto& r) { return r.curve.rows; })
          .number("events",
                  "events",
                  [](auto& r) {
                    double events = 0.0;
                    for (const statistics::SurvivalPoint& point : r.curve.points) {
                      events += point.events;
                    }
                    return events;
                  })
          .time("median", "median", [](auto& r) { return r.median.time; })
          .time("median.low", "low", [](auto& r) { return r.median.low; })
          .time("median.high", "high", [](auto& r) { return r.median.high; })
          .number("rmean", "restricted mean", [](auto& r) { return r.mean.mean; })
          .number("rmean.std.error", "SE", [](auto& r) { return r.mean.std_error; })
          .time("rmean.limit", "up to", [](auto& r) { return r.mean.limit; });
  Table table = columns.table("groups", "Time to the event, by group");
  const double limit = statistics::common_limit(curves);
  for (const statistics::SurvivalCurve& curve : curves) {
    table.add_row(
        columns.row({curve,
                     statistics::survival_quantile(curve, 0.5, options.scale, options.level),
                     statistics::restricted_mean(curve, limit)}));
  }
  return table;
}

struct ShownPoint {
  std::string group;
  double time;
  statistics::SurvivalPoint point;

  const statistics::SurvivalPoint& operator*() const noexcept { return point; }
};

ColumnsOf<ShownPoint> point_columns(const SurvivalReportOptions& options) {
  using Point = statistics::SurvivalPoint;
  const auto interval = [&options](const ShownPoint& r) {
    return statistics::survival_interval(
        r.point.survival, r.point.log_std_error, options.scale, options.level);
  };
  return ColumnsOf<ShownPoint>()
      .text("strata", "group", [](auto& r) { return group_name(r.group); })
      .time("time", "time", &ShownPoint::time)
      .number("n.risk", "at risk", &Point::at_risk)
      .number("n.event", "events", &Point::events)
      .number("n.censor", "censored", &Point::censored)
      .number("estimate", "survival", &Point::survival)
      .number("std.error", "SE", &Point::std_error)
      .ends({"conf.low", "low"}, {"conf.high", "high"}, interval)
      .number("cumhaz", "cumulative hazard", &Point::cumulative_hazard)
      .number("cumhaz.std.error", "SE of hazard", &Point::hazard_std_error);
}

/// The curve just after `time`, with the weight still at risk there.
statistics::SurvivalPoint point_at(const statistics::SurvivalCurve& curve, double time) {
  statistics::SurvivalPoint point;
  if (const statistics::SurvivalPoint* const last = curve.at(time)) {
    point = *last;
  }
  point.events = point.censored = point.at_risk = 0.0;
  for (const statistics::SurvivalPoint& one : curve.points) {
    point.events += one.time <= time ? one.events : 0.0;
    point.censored += one.time <= time ? one.censored : 0.0;
  }
  const auto next = std::find_if(
      curve.points.begin(), curve.points.end(), [&](const statistics::SurvivalPoint& one) {
        return one.time >= time;
      });
  point.at_risk = next == curve.points.end() ? 0.0 : next->at_risk;
  return point;
}

Table times_table(const std::vector<statistics::SurvivalCurve>& curves,
                  const SurvivalReportOptions& options) {
  const ColumnsOf<ShownPoint> columns = point_columns(options);
  Table table = columns.table("times", "Survival at chosen times: the share without the event");
  const std::vector<double> times = shown_times(options, event_times(curves));
  for (const statistics::SurvivalCurve& curve : curves) {
    for (const double time : times) {
      table.add_row(columns.row({curve.group, time, point_at(curve, curve.time_near(time))}));
    }
  }
  table.footnotes = {
      "at risk: just before the time; events and censored: up to the time, that time included."};
  return table;
}

Table all_points(const std::vector<statistics::SurvivalCurve>& curves,
                 const SurvivalReportOptions& options) {
  const ColumnsOf<ShownPoint> columns = point_columns(options);
  Table table = columns.table("curve", "Kaplan-Meier curve");
  for (const statistics::SurvivalCurve& curve : curves) {
    for (const statistics::SurvivalPoint& point : curve.points) {
      table.add_row(columns.row({curve.group, point.time, point}));
    }
  }
  return table;
}

Table test_table(const statistics::LogRankTest& test) {
  using Group = statistics::LogRankGroup;
  return ColumnsOf<Group>()
      .text("strata", "group", &Group::group)
      .integer("records", "rows", &Group::rows)
      .number("observed", "observed", &Group::observed)
      .number("expected", "expected", &Group::expected)
      .table("logrank", "Log-rank test, rho = " + significant(test.rho, kShownDigits), test.groups);
}

}  // namespace

FitReport survival_report(const std::vector<statistics::SurvivalCurve>& curves,
                          const std::optional<statistics::LogRankTest>& test,
                          const SurvivalReportOptions& options) {
  FitReport report;
  report.model = "km";
  report.tables = {group_table(curves, options), times_table(curves, options)};
  report.details = {all_points(curves, options)};
  std::size_t rows = 0;
  for (const statistics::SurvivalCurve& curve : curves) {
    rows += curve.rows;
    report.add(curve.conditions);
  }
  Record summary("summary", "Rows and test");
  summary.integer("n", "rows", rows).integer("groups", "groups", curves.size());
  if (test) {
    summary.number("statistic", "chi-squared", test->chi_squared)
        .integer("df", "df", test->df)
        .p("p.value", "p", test->p_value)
        .number("rho", "rho", test->rho);
    report.tables.push_back(test_table(*test));
    std::vector<std::string> names;
    for (const statistics::LogRankGroup& group : test->groups) {
      names.push_back(group.group);
    }
    report.details.push_back(matrix_table(
        "logrank_vcov", "Covariance of observed less expected", names, test->covariance));
    // Without a test the curves still stand.
    for (statistics::Condition condition : test->conditions) {
      condition.severity = std::min(condition.severity, statistics::ConditionSeverity::warning);
      condition.detail = "no log-rank test";
      report.conditions.push_back(std::move(condition));
    }
  }
  report.summary = std::move(summary).table();
  return report;
}

}  // namespace tcert
