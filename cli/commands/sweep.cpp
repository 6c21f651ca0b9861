#include "cli/runs/experiment/cells.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kSweepText =
    R"(Run the whole way from log to H1 under many parameter values.

--grid KEY=V1,V2,... gives a parameter several values; several --grid give every combination. --cells
takes any list of cells from a CSV file. --sensitivity takes every choice that the paper leaves open,
one at a time, at other values that one could defend: how H1 moves is its specification curve.
The whole grid is checked before anything is run or written: a value that its parameter does not
take, or with which no combination is possible, is an error, and so are more than 10,000 combinations.

With --output DIR: DIR/cells.*, DIR/issuance.*, DIR/speed.* (H3; CSV, JSON, text, Markdown, LaTeX), DIR/features/*.csv and
DIR/replays/*.csv (DIR/files.csv says which cell has which), DIR/manifest.json. Without it: the table on stdout. A cell whose parameters are impossible
together, or any such cell of a file, is refused with the reason, the others run; the exit code is then 3.

Usage: tcert sweep BUNDLE (--grid KEY=VALUES ... | --cells FILE | --sensitivity) [options]

Example:
  tcert sweep corpus --grid memory_weight_m=0,0.05,0.1 --grid early_quantile=0,0.1,0.5
  tcert sweep corpus --sensitivity --output sensitivity

Cost: that of 'tcert certify' for each distinct series; results are kept in the cache as they come, so
a run that was stopped goes on where it was.
)";

int run_sweep(Arguments arguments) { return run_command(kSweepText, arguments, sweep); }

std::vector<CommandForm> sweep_forms() { return {form_for<SweepRequest>(kSweepText)}; }

}  // namespace

const Command kSweep = {"sweep", "run under many parameter values", run_sweep, sweep_forms};

}  // namespace tcert::cli
