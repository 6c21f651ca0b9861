#include "cli/commands/import.hpp"

#include <algorithm>
#include <string>

#include "cli/commands/command_line.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a bundle or a feature table from data in a foreign format.

carmen: a Carnegie Mellon log becomes a bundle of one trial.
barn: public outcomes of the BARN challenge, with the metrics of its worlds, become a feature table.

Usage: tcert import carmen LOG --output DIR [options]
       tcert import barn --trials FILE --metrics FILE --output FILE [options]

'tcert import carmen --help' and 'tcert import barn --help' list the options.

Example:
  tcert import carmen intel.gfs.log.gz --output intel --goal-x -2 --goal-y -14.5 --goal-radius 1
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --output barn.csv

Cost: one pass over the files.
)";

int run(Arguments arguments) {
  const auto names = [&](const char* format) {
    return std::find(arguments.begin(), arguments.end(), format);
  };
  const auto carmen = names("carmen");
  const auto barn = names("barn");
  if (carmen < barn) {
    return import_carmen_command(arguments);
  }
  if (barn < carmen) {
    return import_barn_command(arguments);
  }
  std::string format;
  std::vector<std::string> given;
  OptionTable table(given);
  table.argument({"FORMAT", &format});
  Manner manner;
  if (parse(kText, table, manner, arguments)) {
    throw UsageError("unknown format '" + format + "', expected barn or carmen" +
                     did_you_mean(format, {"barn", "carmen"}));
  }
  return exit_done;
}

}  // namespace

const Command kImport = {
    "import", "make a bundle or a feature table from data in a foreign format", run};

}  // namespace tcert::cli
