#include <algorithm>

#include "reports/columns_of.hpp"
#include "reports/fit/interval_columns.hpp"
#include "reports/fit/shown_times.hpp"
#include "reports/fit/survival_report.hpp"

namespace tcert {
namespace {

/// Of every group; all times if there is no event.
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

/// Weight at risk just before `time`.
double at_risk_before(const statistics::IncidenceCurves& curves, double time) {
  const auto next =
      std::lower_bound(curves.time.begin(), curves.time.end(), curves.time_near(time));
  return next == curves.time.end()
             ? 0.0
             : curves.at_risk[static_cast<std::size_t>(next - curves.time.begin())];
}

/// The state after point `at` of a curve.
struct IncidencePoint {
  const statistics::IncidenceCurves& curves;
  const statistics::IncidenceCurve& curve;
  double time;
  std::size_t at;

  /// Before the first point nothing has happened.
  [[nodiscard]] bool is_before() const { return at >= curves.time.size(); }
  [[nodiscard]] double probability() const { return is_before() ? 0.0 : curve.probability[at]; }
};

ColumnsOf<IncidencePoint> incidence_columns(const SurvivalReportOptions& options) {
  const auto interval = [&options](const IncidencePoint& r) {
    const double p = r.probability();
    return p == 0.0 ? std::nullopt
                    : std::optional(statistics::survival_interval(
                          p, r.curve.std_error[r.at] / p, options.scale, options.level));
  };
  return ColumnsOf<IncidencePoint>()
      .text("strata", "group", [](auto& r) { return group_name(r.curves.group); })
      .text("state", "cause", [](auto& r) { return r.curve.cause; })
      .time("time", "time", &IncidencePoint::time)
      .number("n.risk", "at risk", [](auto& r) { return at_risk_before(r.curves, r.time); })
      .number("estimate", "incidence", &IncidencePoint::probability)
      .number("std.error",
              "SE",
              [](auto& r) {
                return r.is_before() ? std::nullopt : std::optional(r.curve.std_error[r.at]);
              })
      .ends({"conf.low", "low"}, {"conf.high", "high"}, interval);
}

}  // namespace

void add_incidence(const std::vector<statistics::IncidenceCurves>& curves,
                   const SurvivalReportOptions& options,
                   FitReport& report) {
  const std::vector<double> times = shown_times(options, event_times(curves));
  const ColumnsOf<IncidencePoint> columns = incidence_columns(options);
  Table shown = columns.table("incidence", "Cumulative incidence by cause (Aalen-Johansen)");
  Table all = shown;
  all.name = "incidence_curve";
  for (const statistics::IncidenceCurves& group : curves) {
    for (const statistics::IncidenceCurve& curve : group.causes) {
      for (const double time : times) {
        shown.add_row(columns.row({group, curve, time, group.index_at(time)}));
      }
      for (std::size_t i = 0; i < group.time.size(); ++i) {
        all.add_row(columns.row({group, curve, group.time[i], i}));
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

Table gray_table(const std::vector<statistics::GrayTest>& tests, double rho) {
  using Test = statistics::GrayTest;
  Table table = ColumnsOf<Test>()
                    .text("state", "cause", &Test::cause)
                    .part(chi_square_columns(), &Test::test)
                    .table("gray",
                           "Gray's test of equal cumulative incidence, rho = " +
                               significant(rho, kShownDigits),
                           tests);
  table.footnotes = {"Rows are taken as independent, also those of a cluster."};
  return table;
}

Table restricted_mean_table(const std::vector<statistics::RestrictedMeanRow>& rows,
                            double limit,
                            bool clustered) {
  using Row = statistics::RestrictedMeanRow;
  const auto spread = [](auto& r) { return &r.spread; };
  Table table = ColumnsOf<Row>()
                    .text("strata", "group", [](auto& r) { return group_name(r.first); })
                    .text("less", "less", &Row::second)
                    .number("estimate", "mean time", &Row::value)
                    .part(ColumnsOf<statistics::ClusterT>()
                              .number("std.error", "SE", &statistics::ClusterT::standard_error)
                              .number("df", "df", &statistics::ClusterT::df)
                              .p("p.value", "p", &statistics::ClusterT::p_value)
                              .ends({"conf.low", "low"},
                                    {"conf.high", "high"},
                                    &statistics::ClusterT::interval),
                          spread)
                    .table("rmst", "Mean times within [0, " + significant(limit, 6) + "]", rows);
  table.footnotes = {
      clustered
          ? "SE by the jackknife of whole clusters, intervals and p by Student's t with clusters - "
            "1 degrees of freedom."
          : "SE by Greenwood's formula, groups independent; intervals and p by the normal "
            "distribution."};
  return table;
}

}  // namespace tcert
