#include "cli/commands/live_terrain.hpp"

#include "cli/commands/run_command.hpp"
#include "cli/runs/live_terrain/live_terrain.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kLiveTerrainText =
    R"(The loop of a robot that feels its ground: a measurement in, the next place and a certified way out.

The robot measures the cells round its start with plan 0, and last of all, with plan 1, the cell where
it stands. From then on it goes along the way it is told, measures at its end, and asks again. A line
is x,y,value[,plan], whole cells, or {"x": 230, "y": 220, "value": 1359.4, "plan": true}; plan is 1
unless it is said. After a header that names x, y and value columns are found by name, and others are
not looked at, but synthetic_seed, which labels what is written as made by a program. Each line with plan 1 is answered by a row: the columns of series.csv of 'explore'
but those that only the terrain itself knows, the way as places "x y" with ; between, and how it
ended, if it did. A robot that measures elsewhere than it was told to is planned for from there; ways
are certified from where it last measured.

LAYOUT is a terrain file of which the size, the map coordinates and the gaps count, not the values; or
--rows and --columns say the size. Options are those of 'explore'; rules are certified or band. With
the measurements that 'explore' would take, all rows are those of 'explore', byte for byte.

Lines come from stdin and rows go to stdout; with --listen unix:PATH a robot connects, and is answered
there too. --record DIR keeps the run: its measurements.csv is what 'tcert live terrain' reads to run
again, and 'tcert explore --known' to go on from. A line that cannot be is said and skipped, and on a
connection answered by a line '# line N: why'; the exit code is then 3, otherwise that of 'explore'; 5
stands for all that only the terrain could tell apart. A first plan that is refused ends a run from
stdin; who is connected may measure more round the start, and ask again.

Usage: tcert live terrain [LAYOUT] --start X,Y [--goal X,Y] [options] < measurements

Example:
  tcert live terrain --rows 600 --columns 400 --start 300,200 --goal 420,260 --lipschitz 18 < lines
  tcert live terrain dem.asc --start 20,30 --threshold 1000 --listen unix:/run/ground --record run
  tcert live terrain dem.asc --start 20,30 --threshold 1000 < run/measurements.csv

Cost: 5 to 35 ms a step at 240,000 cells; 0.1 to 0.6 s where a bound of L changes (--lipschitz auto).
)";

}  // namespace

int live_terrain_command(Arguments arguments) {
  return run_command(kLiveTerrainText, arguments, live_terrain);
}

CommandForm live_terrain_form() {
  return form_for<LiveTerrainRequest>(kLiveTerrainText, "terrain");
}

}  // namespace tcert::cli
