#include "cli/runs/import_log.hpp"

#include "cli/commands/import.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kImportLogText =
    R"(Make a bundle from logs as a robot's own programs write them.

A source is a bag of ROS 2 (an MCAP file, a rosbag2 database or its folder), a folder of CSV files, or
a CSV file. The map, a small JSON file, says which topics or columns are the pose, the rays and the
commands, in what units, and where outcomes stand: 'tcert check SOURCE --write-map map.json' drafts
it, 'tcert help map' lists its keys with examples. Each bag, and each text that fits {trial} in the
names of files, becomes a trial.

Every row is used or counted: a stream that is required and of which less than 90 % is of use rejects
its trial, and so do streams without a common time. Samples that are late by less than max_gap_s are
put in order; a clock that is set back is said. The map and what was used go into the bundle.

Usage: tcert import log SOURCE... --map FILE --output DIR [options]

Example:
  tcert import log run1.mcap run2.mcap --map map.json --output bundle
  tcert import log runs --map map.json --output bundle && tcert certify bundle --output results

Cost: one pass over the logs; memory does not grow with the length of a bag.
)";

}  // namespace

CommandForm import_log_form() { return form_for<ImportLogRequest>(kImportLogText, "log"); }

int import_log_command(Arguments arguments) {
  return run_command(kImportLogText, arguments, import_log);
}

}  // namespace tcert::cli
