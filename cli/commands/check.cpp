#include "cli/runs/check.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCheckText =
    R"(Look at logs before anything is computed from them, whatever they are.

What it is is found out by what it holds, never by its name.

Of a bundle: each trial's streams, rates, gaps, and whether it starts in S and ends in G; values that
are not what their columns say (degrees in radians, millimetres, grams, headings that do not follow
the motion, a run beside its course); what no working ray does: a contact that never ends though the
ray reads free, a reading that never moves, two rays that are one, a ray without readings.

Of a bag of ROS 2 (MCAP, rosbag2): its topics, their types, rates and clocks. Of a CSV file, or a
folder of them: dialect, header and columns, the clock and its unit, and what each column may be to a
bundle; a table of trials has no clock, but its times are looked at: a stamp among durations, stamps
alone. --write-map drafts the map by which 'tcert import log' makes a bundle of it.

Then every problem, with file, line, column, what was found and what was expected. Ends with 1 if
there is a warning or an error, with 0 otherwise; lines before a header and guesses are notes.

Usage: tcert check SOURCE [options]

Example:
  tcert check corpus
  tcert check run.mcap --write-map map.json
  tcert check runs --write-map map.json

Cost: one pass over the logs; of alike CSV files over the first.
)";

int run_check(Arguments arguments) { return run_command(kCheckText, arguments, check); }

std::vector<CommandForm> check_forms() { return {form_for<CheckRequest>(kCheckText)}; }

}  // namespace

const Command kCheck = {"check",
                        "look at logs of any format before anything is computed from them",
                        run_check,
                        check_forms};

}  // namespace tcert::cli
