#include <stdexcept>

#include "analysis/study/experiment/paper_cells.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/experiment/batch.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Run the whole way from log to H1 under many parameter values.

--grid KEY=V1,V2,... gives a parameter several values; several --grid give every combination. --cells
takes any list of cells from a CSV file. --sensitivity takes every choice that the paper leaves open,
one at a time, at other values that one could defend: how H1 moves is its specification curve.

With --output DIR: DIR/cells.*, DIR/issuance.*, DIR/speed.* (H3; CSV, JSON, text, Markdown, LaTeX), DIR/features/*.csv and
DIR/replays/*.csv (DIR/files.csv says which cell has which), DIR/manifest.json. Without it: the table on stdout. A cell whose parameters are impossible
is refused with the reason, the others run; the exit code is then 3.

Usage: tcert sweep BUNDLE (--grid KEY=VALUES ... | --cells FILE | --sensitivity) [options]

Example:
  tcert sweep corpus --grid memory_weight_m=0,0.05,0.1 --grid early_quantile=0,0.1,0.5
  tcert sweep corpus --sensitivity --output sensitivity

Cost: that of 'tcert certify' for each distinct series; results are kept in the cache as they come, so
a run that was stopped goes on where it was.
)";

std::vector<study::GridAxis> axes_of(const std::vector<std::string>& texts) {
  std::vector<study::GridAxis> axes;
  for (const std::string& text : texts) {
    const auto equals = text.find('=');
    const std::vector<std::string> values = equals == std::string::npos
                                                ? std::vector<std::string>{}
                                                : words_of(text.substr(equals + 1));
    if (equals == 0 || values.empty()) {
      throw UsageError("--grid: found '" + text + "', expected KEY=V1,V2,...");
    }
    axes.push_back({text.substr(0, equals), values});
  }
  return axes;
}

std::vector<study::Cell> cells_of_grid(const std::vector<std::string>& texts) {
  try {
    return study::grid_cells(axes_of(texts));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

int run(Arguments arguments) {
  BatchOptions options;
  CommonOptions common;
  std::vector<std::string> grid;
  bool sensitivity = false;
  CommandLine line{"sweep",
                   kText,
                   uses_parameters | uses_output | uses_format | uses_seed | uses_threads |
                       uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"BUNDLE", &options.bundle, true, OptionRole::input}}};
  line.own.add_options()("grid",
                         po::value(&grid)->composing()->value_name("KEY=VALUES"),
                         "a parameter and its values, comma between; repeatable")(
      "sensitivity",
      po::bool_switch(&sensitivity),
      "every choice that the paper leaves open, one at a time");
  add_batch_options(line.own, options);
  if (!parse(line, common, arguments)) {
    return exit_done;
  }
  const int sources =
      (grid.empty() ? 0 : 1) + (options.cells.empty() ? 0 : 1) + (sensitivity ? 1 : 0);
  if (sources != 1) {
    throw UsageError("needs one of --grid, --cells and --sensitivity");
  }
  std::vector<study::Cell> cells = sensitivity     ? study::sensitivity_cells()
                                   : !grid.empty() ? cells_of_grid(grid)
                                                   : cells_of_file(options.cells, common);
  return run_batch("sweep", options, common, std::move(cells));
}

}  // namespace

const Command kSweep = {"sweep", "run under many parameter values", run};

}  // namespace tcert::cli
