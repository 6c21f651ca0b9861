#include "reports/fit/survival_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <statistics/basics/quantile.hpp>

#include "reports/fit/cells.hpp"

namespace tcert {
namespace {

constexpr std::array kShownShares{0.1, 0.25, 0.5, 0.75, 0.9};

std::string name_of(const std::string& group) { return group.empty() ? "all" : group; }

/// Upwards to two digits.
double rounded(double time) {
  if (!(time > 0.0)) {
    return time;
  }
  const int exponent = static_cast<int>(std::floor(std::log10(time))) - 1;
  // Powers of ten above 1 are exact, so that 0.3 is no 0.30000000000000004.
  const double unit = std::pow(10.0, std::abs(exponent));
  const double digits = std::ceil((exponent < 0 ? time * unit : time / unit) * (1.0 - 1e-12));
  return exponent < 0 ? digits / unit : digits * unit;
}

/// The times that were asked for, or rounded quantiles of the event times up to the limit: one long
/// row then does not leave the others in the first row of a table.
std::vector<double> shown_times(const SurvivalReportOptions& options,
                                const std::vector<double>& event_times) {
  if (!options.times.empty()) {
    return options.times;
  }
  std::vector<double> times;
  for (const double share : kShownShares) {
    if (const auto time = statistics::quantile(event_times, share)) {
      const double shown = rounded(*time);
      if (shown < options.limit.value_or(std::numeric_limits<double>::infinity())) {
        times.push_back(shown);
      }
    }
  }
  if (options.limit) {
    times.push_back(*options.limit);
  }
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

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

std::vector<double> event_times(const std::vector<statistics::IncidenceCurves>& groups) {
  std::vector<double> times;
  std::vector<double> all;
  for (const statistics::IncidenceCurves& curves : groups) {
    all.insert(all.end(), curves.time.begin(), curves.time.end());
    for (const statistics::IncidenceCurve& curve : curves.causes) {
      for (std::size_t k = 0; k < curves.time.size(); ++k) {
        if (curve.events[k] > 0.0) {
          times.push_back(curves.time[k]);
        }
      }
    }
  }
  return times.empty() ? all : times;
}

Table group_table(const std::vector<statistics::SurvivalCurve>& curves,
                  const SurvivalReportOptions& options) {
  Table table;
  table.name = "groups";
  table.title = "Time to the event, by group";
  table.columns = {text_column("strata", "group"),
                   integer_column("records", "rows"),
                   number_column("events", "events"),
                   time_column("median", "median"),
                   time_column("median.low", "low"),
                   time_column("median.high", "high"),
                   number_column("rmean", "restricted mean"),
                   number_column("rmean.std.error", "SE"),
                   time_column("rmean.limit", "up to")};
  const double limit = statistics::common_limit(curves);
  for (const statistics::SurvivalCurve& curve : curves) {
    double events = 0.0;
    for (const statistics::SurvivalPoint& point : curve.points) {
      events += point.events;
    }
    const statistics::SurvivalQuantile median =
        statistics::survival_quantile(curve, 0.5, options.scale, options.level);
    const statistics::RestrictedMean mean = statistics::restricted_mean(curve, limit);
    table.add_row({name_of(curve.group),
                   integer_cell(curve.rows),
                   number_cell(events),
                   number_cell(median.time),
                   number_cell(median.low),
                   number_cell(median.high),
                   number_cell(mean.mean),
                   number_cell(mean.std_error),
                   number_cell(mean.limit)});
  }
  return table;
}

std::vector<Column> curve_columns() {
  return {text_column("strata", "group"),
          time_column("time", "time"),
          number_column("n.risk", "at risk"),
          number_column("n.event", "events"),
          number_column("n.censor", "censored"),
          number_column("estimate", "survival"),
          number_column("std.error", "SE"),
          number_column("conf.low", "low"),
          number_column("conf.high", "high"),
          number_column("cumhaz", "cumulative hazard"),
          number_column("cumhaz.std.error", "SE of hazard")};
}

void add_point(const std::string& group,
               double time,
               const statistics::SurvivalPoint& point,
               const SurvivalReportOptions& options,
               Table& table) {
  const statistics::Interval interval = statistics::survival_interval(
      point.survival, point.log_std_error, options.scale, options.level);
  table.add_row({name_of(group),
                 number_cell(time),
                 number_cell(point.at_risk),
                 number_cell(point.events),
                 number_cell(point.censored),
                 number_cell(point.survival),
                 number_cell(point.std_error()),
                 number_cell(interval.low),
                 number_cell(interval.high),
                 number_cell(point.cumulative_hazard),
                 number_cell(point.hazard_std_error)});
}

/// The curves just after each time, with the weight still at risk there.
Table times_table(const std::vector<statistics::SurvivalCurve>& curves,
                  const SurvivalReportOptions& options) {
  Table table;
  table.name = "times";
  table.title = "Survival at chosen times: the share without the event";
  table.columns = curve_columns();
  const std::vector<double> times = shown_times(options, event_times(curves));
  for (const statistics::SurvivalCurve& curve : curves) {
    for (const double shown : times) {
      const double time = curve.time_near(shown);
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
      add_point(curve.group, shown, point, options, table);
    }
  }
  table.footnotes = {
      "at risk: just before the time; events and censored: up to the time, that time included."};
  return table;
}

Table all_points(const std::vector<statistics::SurvivalCurve>& curves,
                 const SurvivalReportOptions& options) {
  Table table;
  table.name = "curve";
  table.title = "Kaplan-Meier curve";
  table.columns = curve_columns();
  for (const statistics::SurvivalCurve& curve : curves) {
    for (const statistics::SurvivalPoint& point : curve.points) {
      add_point(curve.group, point.time, point, options, table);
    }
  }
  return table;
}

Table test_table(const statistics::LogRankTest& test) {
  Table table;
  table.name = "logrank";
  table.title = "Log-rank test, rho = " + significant(test.rho, kShownDigits);
  table.columns = {text_column("strata", "group"),
                   integer_column("records", "rows"),
                   number_column("observed", "observed"),
                   number_column("expected", "expected")};
  for (const statistics::LogRankGroup& group : test.groups) {
    table.add_row({group.group,
                   integer_cell(group.rows),
                   number_cell(group.observed),
                   number_cell(group.expected)});
  }
  return table;
}

std::vector<Column> incidence_columns() {
  return {text_column("strata", "group"),
          text_column("state", "cause"),
          time_column("time", "time"),
          number_column("n.risk", "at risk"),
          number_column("estimate", "incidence"),
          number_column("std.error", "SE"),
          number_column("conf.low", "low"),
          number_column("conf.high", "high")};
}

/// Weight at risk just before `time`.
double at_risk_before(const statistics::IncidenceCurves& curves, double time) {
  const auto next =
      std::lower_bound(curves.time.begin(), curves.time.end(), curves.time_near(time));
  return next == curves.time.end()
             ? 0.0
             : curves.at_risk[static_cast<std::size_t>(next - curves.time.begin())];
}

/// The state after point `at`; before the first point nothing has happened.
void add_incidence_row(const statistics::IncidenceCurves& curves,
                       const statistics::IncidenceCurve& curve,
                       double time,
                       std::size_t at,
                       const SurvivalReportOptions& options,
                       Table& table) {
  const bool before = at >= curves.time.size();
  const double p = before ? 0.0 : curve.probability[at];
  std::vector<TableCell> cells{name_of(curves.group),
                               curve.cause,
                               number_cell(time),
                               number_cell(at_risk_before(curves, time)),
                               number_cell(p),
                               before ? TableCell{} : number_cell(curve.std_error[at])};
  if (before || p == 0.0) {
    cells.insert(cells.end(), 2, TableCell{});
  } else {
    const statistics::Interval interval =
        statistics::survival_interval(p, curve.std_error[at] / p, options.scale, options.level);
    cells.push_back(number_cell(interval.low));
    cells.push_back(number_cell(interval.high));
  }
  table.add_row(std::move(cells));
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
    report.conditions.insert(
        report.conditions.end(), curve.conditions.begin(), curve.conditions.end());
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

void add_incidence(const std::vector<statistics::IncidenceCurves>& curves,
                   const SurvivalReportOptions& options,
                   FitReport& report) {
  const std::vector<double> times = shown_times(options, event_times(curves));
  Table shown;
  shown.name = "incidence";
  shown.title = "Cumulative incidence by cause (Aalen-Johansen)";
  shown.columns = incidence_columns();
  Table all = shown;
  all.name = "incidence_curve";
  for (const statistics::IncidenceCurves& group : curves) {
    for (const statistics::IncidenceCurve& curve : group.causes) {
      for (const double time : times) {
        add_incidence_row(group, curve, time, group.index_at(time), options, shown);
      }
      for (std::size_t i = 0; i < group.time.size(); ++i) {
        add_incidence_row(group, curve, group.time[i], i, options, all);
      }
    }
    for (const statistics::Condition& condition : group.conditions) {
      // The survival curve of the same group has said most of them.
      const bool known =
          std::any_of(report.conditions.begin(),
                      report.conditions.end(),
                      [&](const statistics::Condition& one) { return one == condition; });
      if (!known) {
        report.conditions.push_back(condition);
      }
    }
  }
  report.tables.push_back(std::move(shown));
  report.details.push_back(std::move(all));
}

}  // namespace tcert
