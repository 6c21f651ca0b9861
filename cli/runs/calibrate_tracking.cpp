#include "cli/runs/calibrate_tracking.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <utility>

#include "analysis/study/tracking/tracking_buffers.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/report_output.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/tracking_runs.hpp"
#include "reports/tracking_report.hpp"

namespace tcert::cli {
namespace {

constexpr std::array kOfModels{
    "braking-mps2", "disturbance-mps2", "disturbance-mps", "exploring-mps", "speeds"};
constexpr std::array kOfRuns{"lag-s", "window-m", "same-time"};

template <std::size_t N>
void refuse_given(const CalibrateTrackingRequest& request,
                  const std::array<const char*, N>& options,
                  const char* where) {
  for (const char* const option : options) {
    if (is_given(request.given, option)) {
      throw UsageError("--" + std::string(option) + " does nothing " + where);
    }
  }
}

FitReport report_of_model(const CalibrateTrackingRequest& request) {
  if (request.model != "double-integrator") {
    throw UsageError("--model: found '" + request.model + "', expected double-integrator");
  }
  refuse_given(request, kOfRuns, "with --model");
  const std::vector<double> speeds = numbers_of("speeds", request.speeds);
  constexpr std::size_t kMostSpeeds = 200;
  const bool rises = std::ranges::adjacent_find(speeds, std::greater_equal<>{}) == speeds.end();
  constexpr double kFastest = 1000.0;
  if (speeds.size() < 2 || speeds.size() > kMostSpeeds || speeds.front() != 0.0 || !rises ||
      !(speeds.back() <= kFastest)) {
    throw UsageError("--speeds: found '" + request.speeds +
                     "', expected 2 to 200 speeds that rise from 0 to at most 1000");
  }
  if (!(request.braking_mps2 > request.disturbance_mps2)) {
    throw UsageError(
        "--disturbance-mps2: expected less than --braking-mps2: what the disturbance takes of it "
        "leaves nothing to brake with, and there is no bound");
  }
  return tracking_bound_report({request.braking_mps2,
                                request.disturbance_mps2,
                                request.disturbance_mps,
                                request.exploring_mps},
                               speeds);
}

FitReport report_of_runs(const CalibrateTrackingRequest& request, Progress& progress) {
  refuse_given(request, kOfModels, "without --model");
  std::error_code error;
  if (!std::filesystem::exists(request.runs, error)) {
    throw NoInput("there is nothing at '" + request.runs + "'");
  }
  table::CsvOptions csv;
  csv.decimal_comma = request.decimal_comma;
  const TrackingRunsResult read = read_tracking_runs(std::filesystem::path(request.runs), csv);
  progress.say(read.diagnostics);
  if (!read.runs) {
    throw BadData("'" + request.runs + "' cannot be used as runs with a nominal path");
  }
  study::TrackingOptions options;
  options.lag_s = request.lag_s;
  options.window_m = request.window_m;
  FitReport report = tracking_buffers_report(
      study::tracking_buffers(*read.runs, options), options, request.same_time);
  if (read.runs->synthetic) {
    report.synthetic = SyntheticLabel{read.runs->seed};
  }
  return report;
}

}  // namespace

OptionTable options_of(CalibrateTrackingRequest& request) {
  OptionTable table(request.given);
  table.argument({"KIND", &request.kind, true, OptionRole::shapes, {"tracking"}});
  table.argument({"RUNS", &request.runs, false, OptionRole::input});
  table
      .add("model",
           request.model,
           "WORD",
           "a table of the closed form of a model, instead of runs: double-integrator")
      .one_of({"double-integrator"});
  table.add("braking-mps2", request.braking_mps2, "A", "of the model: a").within(1e-3, 1e3);
  table
      .add("disturbance-mps2", request.disturbance_mps2, "A", "what a disturbance takes of it: d_a")
      .within(0, 1e3);
  table.add("disturbance-mps", request.disturbance_mps, "V", "how fast it pushes the robot: d_v")
      .within(0, 1e3);
  table
      .add("exploring-mps",
           request.exploring_mps,
           "V",
           "how fast the planner's point leaves the path at most: v_exp")
      .within(0, 1e3);
  table.add(
      "speeds", request.speeds, "LIST", "in m/s, rising from 0: those driven, and those left");
  table
      .add("lag-s",
           request.lag_s,
           "S",
           "the nominal path counts within so many seconds of a sample's time")
      .within(0, 60);
  table
      .add("window-m",
           request.window_m,
           "M",
           "of travel, over which a curvature is told that is not stated; as curvature_window_m")
      .within(1e-3, 1e3);
  table.add("same-time",
            request.same_time,
            "the buffer is the distance from the nominal position of the same time, as the paper "
            "has it, not that from the path");
  table.add("table", request.table, "NAME", "print only this table; a wrong name lists them");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode calibrate_tracking(const CalibrateTrackingRequest& request, Progress& progress) {
  if (request.runs.empty() == request.model.empty()) {
    throw UsageError("expected a table of runs, or --model: one of them");
  }
  if (!request.runs.empty() && !request.output.path.empty()) {
    require_apart(request.runs, request.output.path);
  }
  ReportOutput output(request.output, "calibrate");
  FitReport report =
      request.runs.empty() ? report_of_model(request) : report_of_runs(request, progress);
  Manifest manifest;
  manifest.command = "calibrate";
  record(written(request), manifest);
  manifest.synthetic = report.synthetic;
  if (!request.runs.empty()) {
    manifest.inputs = {{name_of(request.runs), digest_file(request.runs)}};
  }
  output.deliver(std::move(report), request.table, std::move(manifest), progress);
  say_one_file(request.output, progress);
  return exit_done;
}

}  // namespace tcert::cli
