#include "cli/commands/import.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "cli/commands/run_command.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kImportText =
    R"(Make a bundle or a feature table from data in a foreign format.

log: bags of ROS 2 (MCAP, rosbag2) and CSV files of any columns become a bundle, by a map.
carmen: a Carnegie Mellon log becomes a bundle of one trial.
barn: public outcomes of the BARN challenge, with the metrics of its worlds, become a feature table.

Usage: tcert import log SOURCE... --map FILE --output DIR [options]
       tcert import carmen LOG --output DIR [options]
       tcert import barn --trials FILE... --metrics FILE --output FILE [options]

'tcert import log --help' and so on list the options.

Example:
  tcert import log run1.mcap run2.mcap --map map.json --output bundle
  tcert import carmen intel.gfs.log.gz --output intel --goal-x -2 --goal-y -14.5 --goal-radius 1
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --output barn.csv

Cost: one pass over the files.
)";

/// Of an import without a format that is known.
struct ImportRequest {
  std::string format;
  std::vector<std::string> given;
};

OptionTable options_of(ImportRequest& request) {
  OptionTable table(request.given);
  table.argument({"FORMAT", &request.format, true, OptionRole::shapes, {"barn", "carmen", "log"}});
  return table;
}

struct Format {
  std::string_view name;
  int (*run)(Arguments);
};

constexpr std::array kFormats{Format{"barn", import_barn_command},
                              Format{"carmen", import_carmen_command},
                              Format{"log", import_log_command}};

int run_import(Arguments arguments) {
  for (const auto& argument : arguments) {
    const auto* const format = std::ranges::find(kFormats, argument, &Format::name);
    if (format != kFormats.end()) {
      return format->run(arguments);
    }
  }
  ImportRequest request;
  Manner manner;
  if (parse(kImportText, options_of(request), manner, arguments)) {
    throw UsageError("unknown format '" + request.format + "', expected log, carmen or barn" +
                     did_you_mean(request.format, {"barn", "carmen", "log"}));
  }
  return exit_done;
}

std::vector<CommandForm> import_forms() {
  return {form_for<ImportRequest>(kImportText),
          import_log_form(),
          import_carmen_form(),
          import_barn_form()};
}

}  // namespace

const Command kImport = {"import",
                         "make a bundle or a feature table from data in a foreign format",
                         run_import,
                         import_forms};

}  // namespace tcert::cli
