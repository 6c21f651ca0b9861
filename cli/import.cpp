#include <charconv>
#include <optional>

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "datasets/csv_write.hpp"
#include "datasets/import_carmen.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a bundle of a foreign log.

carmen: a Carnegie Mellon log, plain, .gz or .zst; its FLASER scans become one range ray a beam at
the corrected pose of the scan. S is a disc at the first pose, G the disc given with --goal; without
--goal there is the on-policy corridor value but no certificate.

Usage: tcert import carmen LOG --output DIR [options]

Example:
  tcert import carmen intel.gfs.log.gz --output intel --goal 8.5,-20.3,1.0
  tcert certify intel --output intel-certified

Cost: one pass over the log, which is held in memory.
)";

struct ImportOptions {
  std::string kind;
  std::string log;
  std::string goal;
  CarmenImportOptions carmen;
};

CommandLine command_line(ImportOptions& o) {
  CommandLine line{"import",
                   kText,
                   uses_output | uses_config,
                   po::options_description("Options"),
                   {{"a kind of log: carmen", &o.kind}, {"LOG", &o.log}}};
  CarmenImportOptions& c = o.carmen;
  line.own.add_options()("goal",
                         po::value(&o.goal)->value_name("X,Y,RADIUS"),
                         "G in metres, at a place that the robot visits late; needed for T_t")(
      "start-radius",
      po::value(&c.start_radius_m)->value_name("M")->default_value(c.start_radius_m),
      "of S; raise it if the log begins with the robot moving")(
      "body-width",
      po::value(&c.body_width_m)->value_name("M")->default_value(c.body_width_m),
      "of the robot; the log does not say")(
      "reach",
      po::value(&c.reach_m)->value_name("M")->default_value(c.reach_m),
      "readings of this and more count as this; the range up to which beams can be trusted")(
      "trial-id",
      po::value(&c.trial_id)->value_name("NAME")->default_value(c.trial_id),
      "of the one trial of the bundle");
  return line;
}

/// "x,y,radius". \throws UsageError.
Disc disc_of(const std::string& text) {
  std::array<double, 3> values{};
  const char* at = text.data();
  const char* end = at + text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto read = std::from_chars(at, end, values.at(i));
    const bool last = i + 1 == values.size();
    const bool good =
        read.ec == std::errc{} && (last ? read.ptr == end : read.ptr < end && *read.ptr == ',');
    if (!good) {
      throw UsageError("--goal: found '" + text + "', expected x,y,radius in metres");
    }
    at = last ? end : read.ptr + 1;
  }
  require_range("goal", values[2], 1e-3, 1e6);
  return {{values[0], values[1]}, values[2]};
}

std::string described(const CarmenSummary& summary) {
  return std::to_string(summary.scans) + " scans of " + std::to_string(summary.beams) +
         " beams over " + fixed(summary.duration_s, 0) + " s and " + fixed(summary.distance_m, 1) +
         " m, " + fixed(summary.median_step_m, 2) + " m apart (median; longest " +
         fixed(summary.longest_step_m, 2) + " m).";
}

int run(Arguments arguments) {
  ImportOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (options.kind != "carmen") {
    throw UsageError("unknown kind of log '" + options.kind + "'" +
                     did_you_mean(options.kind, {"carmen"}) + " (known: carmen)");
  }
  if (common.output.empty()) {
    throw UsageError("needs --output DIR");
  }
  if (!options.goal.empty()) {
    options.carmen.goal = disc_of(options.goal);
  }
  require_range("start-radius", options.carmen.start_radius_m, 1e-3, 1e6);
  require_range("body-width", options.carmen.body_width_m, 1e-3, 1e6);
  require_range("reach", options.carmen.reach_m, 1e-3, 1e6);
  std::error_code error;
  if (!std::filesystem::exists(options.log, error)) {
    throw NoInput("no log at '" + options.log + "'");
  }
  ResultFolder folder(common.output);
  options.carmen.replace = true;  // the folder's own staging, empty
  CarmenImportResult result;
  try {
    result = import_carmen(options.log, folder.staging(), options.carmen);
  } catch (const std::invalid_argument& problem) {
    throw UsageError(problem.what());
  }
  say(result.diagnostics);
  if (!result.summary) {
    throw BadData("'" + options.log + "' cannot be imported");
  }
  Manifest manifest;
  manifest.command = "import carmen";
  manifest.options = common.effective;
  manifest.inputs = {{name_of(options.log), digest_file(options.log)}};
  folder.commit(std::move(manifest));
  if (!common.quiet) {
    say(described(*result.summary));
  }
  return exit_done;
}

}  // namespace

const Command kImport = {"import", "make a bundle of a foreign log: carmen", run};

}  // namespace tcert::cli
