#include "reports/tracking_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <table/csv_write.hpp>

#include "reports/columns_of.hpp"
#include "reports/findings.hpp"
#include "reports/table_json.hpp"

namespace tcert {
namespace {

constexpr int kTrackingDecimals = 4;
constexpr double kUsual = 0.95;

Table runs_table(const study::TrackingBuffers& buffers, const study::TrackingOptions& options) {
  using study::RunErrors;
  Table table =
      ColumnsOf<RunErrors>()
          .text("run", "run", &RunErrors::run)
          .text("day", "day", &RunErrors::day)
          .integer("samples", "samples", &RunErrors::samples)
          .fixed("travel_m", "travel", "m", 2, &RunErrors::travel_m)
          .fixed("path_distance_m", "from path", "m", kTrackingDecimals, &RunErrors::path_m)
          .fixed("path_distance_time_s", "at", "s", 2, &RunErrors::path_time_s)
          .fixed("same_time_m", "from point", "m", kTrackingDecimals, &RunErrors::same_time_m)
          .fixed(
              "curvature_per_m", "curvature", "1/m", kTrackingDecimals, &RunErrors::curvature_per_m)
          .fixed("curvature_time_s", "at", "s", 2, &RunErrors::curvature_time_s)
          .fixed("excess_per_m", "excess", "1/m", kTrackingDecimals, &RunErrors::excess_per_m)
          .table("tracking_runs", "The largest errors of each run", buffers.runs);
  table.footnotes = {
      fmt::format(
          "from path: of the executed position from the nominal path, a polyline, within {} s of "
          "its time; from point: from the nominal position of the same time (the paper's "
          "formula).",
          table::number_text(options.lag_s)),
      "curvature: |executed - nominal| at the same time; excess: |executed| - |nominal|, which is "
      "never more."};
  return table;
}

/// What n independent maxima bound, in one sentence.
std::string wilks_sentence(std::size_t n, const char* what) {
  return fmt::format(
      "If {} are independent draws, this bounds {:.1f} % of all {} with 95 % confidence, and 95 % "
      "of them with {:.1f} % (n = {}{}).",
      what,
      100.0 * study::wilks_share(n, kUsual),
      what,
      100.0 * study::wilks_confidence(n, kUsual),
      n,
      study::wilks_confidence(n, kUsual) >= kUsual ? "" : "; 95 % with 95 % takes 59");
}

std::string settings_text(double buffer_m, const std::optional<double>& curvature_per_m) {
  std::string text = "tracking_buffer_m=" + table::number_text(buffer_m) + '\n';
  if (curvature_per_m) {
    text += "curvature_buffer_per_m=" + table::number_text(*curvature_per_m) + '\n';
  }
  return text;
}

}  // namespace

FitReport tracking_buffers_report(const study::TrackingBuffers& buffers,
                                  const study::TrackingOptions& options,
                                  bool same_time) {
  const double buffer_m = same_time ? buffers.same_time_m : buffers.path_m;
  FitReport report;
  report.model = "calibrate tracking";
  std::string bounds = wilks_sentence(buffers.runs.size(), "runs");
  if (buffers.days > 0) {
    bounds += " Runs of a day may share an error: " + wilks_sentence(buffers.days, "days");
  }
  std::vector<Finding> findings{
      {"Tracking",
       "",
       fmt::format("The executed position was at most {:.{}f} m from the nominal {}: "
                   "tracking_buffer_m. {}",
                   buffer_m,
                   kTrackingDecimals,
                   same_time ? "one of the same time" : "path",
                   bounds)}};
  findings.push_back(
      {"Curvature",
       "",
       buffers.curvature_per_m
           ? fmt::format("It was at most {:.{}f} 1/m off the nominal one: curvature_buffer_per_m.",
                         *buffers.curvature_per_m,
                         kTrackingDecimals)
           : fmt::format("No run travelled {} m: there is none to tell, and no buffer.",
                         table::number_text(options.window_m))});
  report.findings = findings_table(
      findings,
      {"A maximum over runs bounds other runs of the same robot, controller, ground and "
       "kind of path, and nothing beyond them."});
  Record summary("summary", "The buffers");
  summary.integer("runs", "runs", buffers.runs.size())
      .integer("days", "days", buffers.days)
      .number("tracking_buffer_m", "tracking buffer, m", buffer_m)
      .number("curvature_buffer_per_m", "curvature buffer, 1/m", buffers.curvature_per_m)
      .integer("without_curvature", "runs too short for a curvature", buffers.without_curvature)
      .number("share_of_runs",
              "share of runs bounded with 95 % confidence",
              study::wilks_share(buffers.runs.size(), kUsual))
      .number("confidence",
              "confidence that 95 % of runs are",
              study::wilks_confidence(buffers.runs.size(), kUsual));
  if (buffers.days > 0) {
    summary
        .number("share_of_days",
                "share of days bounded with 95 % confidence",
                study::wilks_share(buffers.days, kUsual))
        .number("confidence_days",
                "confidence that 95 % of days are",
                study::wilks_confidence(buffers.days, kUsual));
  }
  report.summary = std::move(summary).table();
  report.tables = {runs_table(buffers, options)};
  OrderedJson robot = OrderedJson::object();
  robot["tracking_buffer_m"] = buffer_m;
  if (buffers.curvature_per_m) {
    robot["curvature_buffer_per_m"] = *buffers.curvature_per_m;
  }
  report.attachments = {
      {"buffers", "For --config:", settings_text(buffer_m, buffers.curvature_per_m), "ini"},
      {"robot", "For bundle.json, in 'robot':", dumped(robot, 1)}};
  return report;
}

FitReport tracking_bound_report(const DoubleIntegrator& model,
                                const std::vector<double>& speeds_mps) {
  struct Knot {
    double speed_mps;
    double left_mps;
    double disturbance;
    double radius_m;
    double hold_s;
  };
  std::vector<Knot> knots;
  for (const double speed : speeds_mps) {
    for (const double left : speeds_mps) {
      for (const double level : {0.0, 1.0}) {
        const DoubleIntegrator at{model.braking_mps2,
                                  level * model.disturbance_mps2,
                                  level * model.disturbance_mps,
                                  model.exploring_mps};
        knots.push_back({speed,
                         left,
                         level,
                         tracking_radius_m(at, std::max(speed, left)),
                         tracking_hold_s(model, left)});
      }
    }
  }
  FitReport report;
  report.model = "calibrate tracking";
  const double top = speeds_mps.back();
  report.findings = findings_table(
      {{"Tracking error",
        "",
        fmt::format(
            "At {} m/s the robot stays within {:.{}f} m of its path, within {:.{}f} m under the "
            "disturbance. A radius goes on holding for up to {:.2f} s after the speed has "
            "fallen.",
            table::number_text(top),
            tracking_radius_m({model.braking_mps2, 0.0, 0.0, model.exploring_mps}, top),
            kTrackingDecimals,
            tracking_radius_m(model, top),
            kTrackingDecimals,
            tracking_hold_s(model, top))}},
      {"Double integrator per axis, closed form: (v + d_v)^2 / (a - d_a) + v_exp (2 v + v_exp / 2) "
       "/ (a - d_a). It is convex, so that between knots the interpolated radius is never below "
       "it."});
  Record summary("summary", "The model");
  summary.number("braking_mps2", "braking a, m/s^2", model.braking_mps2)
      .number("disturbance_mps2", "disturbance d_a, m/s^2", model.disturbance_mps2)
      .number("disturbance_mps", "disturbance d_v, m/s", model.disturbance_mps)
      .number("exploring_mps", "exploring speed v_exp, m/s", model.exploring_mps)
      .integer("knots", "knots", knots.size());
  report.summary = std::move(summary).table();
  Table table =
      ColumnsOf<Knot>()
          .fixed("speed_mps", "speed", "m/s", kTrackingDecimals, &Knot::speed_mps)
          .fixed("speed_left_mps", "speed left", "m/s", kTrackingDecimals, &Knot::left_mps)
          .fixed("disturbance", "disturbance", "", 1, &Knot::disturbance)
          .fixed("radius_m", "radius", "m", kTrackingDecimals, &Knot::radius_m)
          .fixed("hold_s", "holds for", "s", kTrackingDecimals, &Knot::hold_s)
          .table("tracking_error", "Tracking error r_TE", knots);
  table.footnotes = {"speed left: the greater speed before; its radius holds for that long after."};
  report.tables = {std::move(table)};
  return report;
}

}  // namespace tcert
