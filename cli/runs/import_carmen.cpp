#include "cli/runs/import_carmen.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <table/path_name.hpp>

namespace tcert::cli {
namespace {

CarmenReading reading_of(const ImportCarmenRequest& request) {
  CarmenReading reading;
  if (request.fov_deg) {
    reading.fov_rad = *request.fov_deg * std::numbers::pi / 180.0;
  }
  if (request.clock == "order") {
    reading.clock = CarmenClock::order;
  } else if (request.clock == "logger") {
    reading.clock = CarmenClock::logger;
  } else if (request.clock != "ipc") {
    throw UsageError("--clock: found '" + request.clock + "', expected ipc, logger or order" +
                     did_you_mean(request.clock, {"ipc", "logger", "order"}));
  }
  const bool is_order = reading.clock == CarmenClock::order;
  if (is_order != request.rate_hz.has_value()) {
    throw UsageError(is_order ? "--clock order needs --rate HZ, the scans in a second"
                              : "--rate does nothing without --clock order");
  }
  reading.rate_hz = request.rate_hz.value_or(0.0);
  return reading;
}

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
  carmen.reading = reading_of(request);
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
  table
      .add("fov",
           request.fov_deg,
           "DEG",
           "of FLASER records: the beams spread from -DEG/2 to +DEG/2, one at each end; needed for "
           "other numbers of beams than 180, 181, 360 and 361")
      .within(1e-3, 360.0);
  table
      .add("clock",
           request.clock,
           "WORD",
           "times of the scans: ipc or logger, the stamps of the records, or order, their order")
      .one_of({"ipc", "logger", "order"});
  table.add("rate", request.rate_hz, "HZ", "scans in a second, with --clock order")
      .within(0.02, 1e6);
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
    throw BadData("'" + request.log + "' cannot be imported; nothing is written");
  }
  const CarmenSummary& made = *result.summary;
  const std::string missing =
      made.missing_readings == 0 ? "" : fmt::format(", {} readings missing", made.missing_readings);
  progress.sum_up(
      fmt::format("{} scans of {} beams, {:.1f} m in {:.0f} s, {:.2f} m between scans (median of "
                  "all steps), {:.2f} m at most; {} readings clamped to {} m{}. Bundle: {}",
                  made.scans,
                  made.beams,
                  made.distance_m,
                  made.duration_s,
                  made.median_step_m,
                  made.longest_step_m,
                  made.clamped_readings,
                  made.reach_m,
                  missing,
                  output));
  return exit_done;
}

}  // namespace tcert::cli
