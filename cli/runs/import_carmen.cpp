#include "cli/runs/import_carmen.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <table/path_name.hpp>

namespace tcert::cli {
namespace {

CarmenImportOptions carmen_options(const ImportCarmenRequest& request) {
  CarmenImportOptions carmen = request.carmen;
  if (!table::is_file_name(carmen.trial_id)) {
    throw UsageError("--trial-id: found '" + table::shortened(carmen.trial_id) + "', expected " +
                     std::string(table::kFileNameRule));
  }
  if (request.goal_x_m.has_value() != request.goal_y_m.has_value()) {
    throw UsageError("--goal-x and --goal-y go together");
  }
  if (request.goal_x_m && request.goal_y_m) {
    carmen.goal = Disc{{*request.goal_x_m, *request.goal_y_m}, request.goal_radius_m};
  }
  return carmen;
}

}  // namespace

OptionTable options_of(ImportCarmenRequest& request) {
  CarmenImportOptions& carmen = request.carmen;
  OptionTable table(request.given);
  table.argument({"FORMAT", &request.format});
  table.argument({"LOG", &request.log, true, OptionRole::input});
  table.add("goal-x", request.goal_x_m, "M", "centre of G in the frame of the log")
      .within(-1e9, 1e9);
  table.add("goal-y", request.goal_y_m, "M", "the same").within(-1e9, 1e9);
  table.add("goal-radius", request.goal_radius_m, "M", "of G").within(1e-3, 1e3);
  table.add("start-radius", carmen.start_radius_m, "M", "of S, round the first pose")
      .within(1e-3, 1e3);
  table.add("body-width", carmen.body_width_m, "M", "w_B of the robot").within(1e-3, 1e3);
  table
      .add("reach",
           carmen.reach_m,
           "M",
           "longest clearance that a beam is trusted with; longer ones are clamped")
      .within(1e-3, 1e4);
  table.add("trial-id", carmen.trial_id, "ID", "name of the one trial");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode import_carmen(const ImportCarmenRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output DIR");
  }
  if (!std::filesystem::exists(request.log)) {
    throw NoInput("there is nothing at " + request.log);
  }
  const CarmenImportResult result =
      tcert::import_carmen(request.log, output, carmen_options(request));
  progress.say(result.diagnostics);
  if (!result.summary) {
    throw BadData(request.log + " holds no scan that can be used");
  }
  const CarmenSummary& made = *result.summary;
  progress.sum_up(
      fmt::format("{} scans of {} beams, {:.1f} m in {:.0f} s, {:.2f} m between scans (median of "
                  "all steps), {:.2f} m at most; {} readings clamped to {} m. Bundle: {}",
                  made.scans,
                  made.beams,
                  made.distance_m,
                  made.duration_s,
                  made.median_step_m,
                  made.longest_step_m,
                  made.clamped_readings,
                  request.carmen.reach_m,
                  output));
  return exit_done;
}

}  // namespace tcert::cli
