#include "cli/runs/simulate.hpp"

#include "cli/commands/run_command.hpp"
#include "cli/runs/simulate_terrain.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kSimulateText =
    R"(Make the synthetic corpus: a bundle with everything that the paper publishes about its 660 trials
built in, and everything else declared. It tests and shows the tool; it says nothing about a robot.

The CSV files begin with a line '# ...' that says that they are synthetic. pandas reads them by
read_csv(FILE, comment='#'). R reads them by read.csv(FILE, comment.char = '#').

Usage: tcert simulate --output DIR [options]
       tcert simulate terrain --output FILE [options]   (see 'tcert simulate terrain --help')

Example:
  tcert simulate --output corpus
  tcert simulate --output null --effect 0 --seed 7
  tcert simulate --output gates --micro-study

Cost: about 2 ms and 115 kB a trial (five times that at native rates).
)";

constexpr std::string_view kTerrainText =
    R"(Make a random terrain whose Lipschitz constant is stated: no two cells differ by more than it times
their distance. 256 random waves with the covariance of a Gaussian process, scaled; or craters by a
stated law, as a stand-in for a digital elevation model, which are not scaled.

Usage: tcert simulate terrain --output FILE [options]

Example:
  tcert simulate terrain --output terrain.csv
  tcert simulate terrain --output small.csv --rows 80 --columns 60 --length-scale 10 --lipschitz 40
  tcert simulate terrain --output craters.csv --kind craters --rows 300 --columns 200

Cost: 0.2 s at 600 x 400 cells.
)";

int run_simulate(Arguments arguments) {
  if (!arguments.empty() && arguments.front() == "terrain") {
    return run_command(kTerrainText, arguments.subspan(1), simulate_terrain);
  }
  return run_command(kSimulateText, arguments, simulate);
}

std::vector<CommandForm> simulate_forms() {
  return {form_for<SimulateRequest>(kSimulateText),
          form_for<SimulateTerrainRequest>(kTerrainText, "terrain")};
}

}  // namespace

const Command kSimulate = {"simulate", "make the synthetic corpus", run_simulate, simulate_forms};

}  // namespace tcert::cli
