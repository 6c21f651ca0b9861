#include "cli/runs/figures/figures.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kFiguresText =
    R"(Draw the figures of results for a paper.

RESULTS is a folder as 'tcert reproduce' makes it, or any folder of folders that the commands wrote.
Every figure that they allow goes to DIR as Vega-Lite (NAME.vl.json), its data (NAME.csv), a gnuplot
script (NAME.gp) and, where gnuplot is installed, SVG and PDF; what is missing is said. The scripts
read the CSV beside them: 'gnuplot -c roc.gp pdf'.

Usage: tcert figures RESULTS --output DIR [options]

Example:
  tcert figures results --output figures
  tcert figures results --output figures --trials t0000007,t0000012

Cost: a few seconds.
)";

int run_figures(Arguments arguments) { return run_command(kFiguresText, arguments, figures); }

std::vector<CommandForm> figures_forms() { return {form_for<FiguresRequest>(kFiguresText)}; }

}  // namespace

const Command kFigures = {
    "figures", "draw the figures of results for a paper", run_figures, figures_forms};

}  // namespace tcert::cli
