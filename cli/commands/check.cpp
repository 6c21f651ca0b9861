#include "cli/runs/check.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Look at logs before anything is computed from them: a bundle, or any single CSV file.

Of a bundle: each trial's streams, rates, gaps, and whether it starts in S and ends in G; values that
are not what their columns say (degrees in radians, millimetres, grams, headings that do not follow
the motion, a run beside its course); what no working ray does: a contact that never ends though the
ray reads free, a reading that never moves, two rays that are one, a ray without readings.

Of a CSV file: its dialect, header and columns, and the clock of a stream: a table of trials
has none, but its times are looked at: a stamp among durations, stamps alone.

Then every problem, with file, line, column, what was found and what was expected. Ends with 1 if
there is a warning or an error, with 0 otherwise.

Usage: tcert check BUNDLE|FILE [options]

Example:
  tcert check corpus
  tcert check run.csv.gz --format json

Cost: one pass over the logs.
)";

int run(Arguments arguments) { return run_command(kText, arguments, check); }

std::vector<CommandForm> forms() { return {form_for<CheckRequest>(kText)}; }

}  // namespace

const Command kCheck = {"check", "look at logs before anything is computed from them", run, forms};

}  // namespace tcert::cli
