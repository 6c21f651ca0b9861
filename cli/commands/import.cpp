#include "cli/commands/import.hpp"

#include <algorithm>
#include <string>

#include "cli/commands/run_command.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a bundle or a feature table from data in a foreign format.

carmen: a Carnegie Mellon log becomes a bundle of one trial.
barn: public outcomes of the BARN challenge, with the metrics of its worlds, become a feature table.

Usage: tcert import carmen LOG --output DIR [options]
       tcert import barn --trials FILE... --metrics FILE --output FILE [options]

'tcert import carmen --help' and 'tcert import barn --help' list the options.

Example:
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
  table.argument({"FORMAT", &request.format, true, OptionRole::shapes, {"barn", "carmen"}});
  return table;
}

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
  ImportRequest request;
  Manner manner;
  if (parse(kText, options_of(request), manner, arguments)) {
    throw UsageError("unknown format '" + request.format + "', expected barn or carmen" +
                     did_you_mean(request.format, {"barn", "carmen"}));
  }
  return exit_done;
}

std::vector<CommandForm> forms() {
  return {form_for<ImportRequest>(kText), import_carmen_form(), import_barn_form()};
}

}  // namespace

const Command kImport = {
    "import", "make a bundle or a feature table from data in a foreign format", run, forms};

}  // namespace tcert::cli
