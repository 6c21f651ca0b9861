#include "cli/runs/explore.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kExploreText =
    R"(Explore a terrain that is felt one cell at a time: measure, grow the ground that is certified
safe, go to the next cell, until the goal is joined or no cell can make the ground grow.

TERRAIN is a rectangle of numbers, higher is safer; x counts its lines, y its columns, from 0. Or a
list of points x,y,value on an evenly spaced lattice: x and y count its first and second coordinate
upwards. Or an ESRI ASCII grid (.asc): x counts its rows from north to south, y its columns from west
to east. All lengths, L and length scales are in cells unless --units metres says otherwise. Cells
without a number, beyond +-1e30, or of a nodata value (--nodata) are gaps: nobody measures or goes
there.

--config reads the published configuration file ([environment] THRESHOLD = 1000, ...; STARTING_X and
GOAL_X are --start and --goal, FRAMECOUNT is --frames); flags go first. --rules: 'certified'
certifies by measurements and the Lipschitz constant alone; 'band' by a Gaussian process, without
that constant; 'thesis' is Algorithm 1 as printed; 'published' is the published program. A flag that
the rules would not look at is an error.

What 'auto' and 'band' say holds for a Gaussian field with a squared-exponential covariance of the
length scale that they are told ('band': or a longer one), alike everywhere. On ground full of craters
that begins on a plain neither holds: a bound from the plain let unsafe cells pass for safe; give
--lipschitz, or --gradient-prior from earlier ground of the kind.

--trust-model lets the model certify too, from a band of sqrt(beta) sd; that proves nothing. Random
terrains of 300 in which it held an unsafe cell safe, L as given: beta 3 (1.73 sd) 145, 9 (3 sd) 72,
16 (4 sd) 11, 25 (5 sd, the default with --trust-model) 2, 36 (6 sd) 0.

Exit codes: 0 the goal is reached, or without a goal all is explored; otherwise, the result written
all the same, 4 not reachable at this threshold (or past the obstacles and gaps, or with this body),
5 only the Lipschitz constant (or the rule set) forbids it, 6 the goal is certified and joined but less than
--simplification cells within the outline (published rules), 7 the limit of --max-steps, 8 stranded
or nothing safe. 2, 65 and 66: wrong flags, a start, goal or terrain that cannot be, no such file.

With --output DIR: DIR/series.csv (one row a step), DIR/path.csv (in cells, under --units metres on the
map too), DIR/measurements.csv (for --known), DIR/frames/frame_*.svg (x to the right, y down),
DIR/rasters/* (as a map lies) and DIR/manifest.json. Without it: the summary alone.

Usage: tcert explore TERRAIN --start X,Y [--goal 'X,Y;X,Y'] [options]

Example:
  tcert simulate terrain --output terrain.csv --seed 3
  tcert explore terrain.csv --start 300,200 --goal 420,260 --lipschitz 18 --output run
  tcert explore terrain.csv --config config.toml --rules published --header yes
  tcert explore dem.asc --start 20,30 --goal 10,50 --threshold 1000 --lipschitz 25 --nodata -9999
  tcert explore terrain.csv --start 300,200 --mode explore --max-steps 100 --lipschitz auto
  tcert explore dem.asc --units metres --start 412030,5021140 --goal 412110,5021105 --lipschitz 5 \
    --kernel-length-scale 20 --body 1.2,0.6,90 --threshold 0 --rasters asc,png --output run

Cost: 5 to 35 ms a step at 240,000 cells (0.1 to 0.6 s where --lipschitz auto changes its bound), and
60 MB at 500 measurements.
)";

int run_explore(Arguments arguments) { return run_command(kExploreText, arguments, explore); }

std::vector<CommandForm> explore_forms() { return {form_for<ExploreRequest>(kExploreText)}; }

}  // namespace

const Command kExplore = {
    "explore", "explore a terrain that is felt one cell at a time", run_explore, explore_forms};

}  // namespace tcert::cli
