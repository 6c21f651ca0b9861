#include "datasets/import_carmen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <table/diagnostic.hpp>
#include <table/path_name.hpp>

#include "cli/errors.hpp"
#include "cli/import.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a bundle from a Carnegie Mellon log (plain, .gz or .zst).

Each FLASER record, with its corrected pose,
becomes a tick with one range ray a beam; ODOM records are raw odometry in another frame and are only
counted. The bundle's parameters suit scans up to about a metre apart (of the Intel log: 0.67 m,
the median of all steps; it is printed for every log); change them with --set when certifying. S is a disc round the first pose; G is where you say, and without it there is the on-policy
corridor value but no certificate.

Usage: tcert import carmen LOG --output DIR [options]

Example:
  tcert import carmen intel.gfs.log.gz --output intel --goal-x -2 --goal-y -14.5 --goal-radius 1
  tcert certify intel --output results

Cost: one pass over the log.
)";

constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();

struct ImportOptions {
  std::string format;
  std::string log;
  double goal_x_m = kUnset;
  double goal_y_m = kUnset;
  double goal_radius_m = 1.0;
  CarmenImportOptions carmen;
};

CommandLine command_line(ImportOptions& o) {
  CommandLine line{"import carmen",
                   kText,
                   uses_output | uses_config,
                   po::options_description("Options"),
                   {{"FORMAT", &o.format}, {"LOG", &o.log, true, OptionRole::input}}};
  line.own.add_options()(
      "goal-x", po::value(&o.goal_x_m)->value_name("M"), "centre of G in the frame of the log")(
      "goal-y", po::value(&o.goal_y_m)->value_name("M"), "the same")(
      "goal-radius",
      po::value(&o.goal_radius_m)->value_name("M")->default_value(o.goal_radius_m),
      "of G")("start-radius",
              po::value(&o.carmen.start_radius_m)->value_name("M")->default_value(0.5, "0.5"),
              "of S, round the first pose")(
      "body-width",
      po::value(&o.carmen.body_width_m)->value_name("M")->default_value(0.45, "0.45"),
      "w_B of the robot")("reach",
                          po::value(&o.carmen.reach_m)->value_name("M")->default_value(8.0, "8"),
                          "longest clearance that a beam is trusted with; longer ones are clamped")(
      "trial-id",
      po::value(&o.carmen.trial_id)->value_name("ID")->default_value(o.carmen.trial_id),
      "name of the one trial");
  return line;
}

CarmenImportOptions carmen_options(const ImportOptions& options) {
  CarmenImportOptions carmen = options.carmen;
  if (!table::is_file_name(carmen.trial_id)) {
    throw UsageError("--trial-id: found '" + table::shortened(carmen.trial_id) + "', expected " +
                     std::string(table::kFileNameRule));
  }
  require_range("start-radius", carmen.start_radius_m, 1e-3, 1e3);
  require_range("body-width", carmen.body_width_m, 1e-3, 1e3);
  require_range("reach", carmen.reach_m, 1e-3, 1e4);
  require_range("goal-radius", options.goal_radius_m, 1e-3, 1e3);
  if (std::isnan(options.goal_x_m) != std::isnan(options.goal_y_m)) {
    throw UsageError("--goal-x and --goal-y go together");
  }
  if (!std::isnan(options.goal_x_m)) {
    carmen.goal = Disc{{options.goal_x_m, options.goal_y_m}, options.goal_radius_m};
  }
  return carmen;
}

}  // namespace

int import_carmen_command(Arguments arguments) {
  ImportOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (common.output.empty()) {
    throw UsageError("needs --output DIR");
  }
  if (!std::filesystem::exists(options.log)) {
    throw NoInput("there is nothing at " + options.log);
  }
  const CarmenImportResult result =
      import_carmen(options.log, common.output, carmen_options(options));
  say(result.diagnostics);
  if (!result.summary) {
    throw BadData(options.log + " holds no scan that can be used");
  }
  const CarmenSummary& made = *result.summary;
  if (!common.quiet) {
    say(
        fmt::format("{} scans of {} beams, {:.1f} m in {:.0f} s, {:.2f} m between scans (median of "
                    "all steps), {:.2f} "
                    "m at most; {} readings clamped to {} m. Bundle: {}",
                    made.scans,
                    made.beams,
                    made.distance_m,
                    made.duration_s,
                    made.median_step_m,
                    made.longest_step_m,
                    made.clamped_readings,
                    options.carmen.reach_m,
                    common.output));
  }
  return exit_done;
}

}  // namespace tcert::cli
