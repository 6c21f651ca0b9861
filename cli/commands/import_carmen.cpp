#include "cli/runs/import_carmen.hpp"

#include "cli/commands/import.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a bundle from a Carnegie Mellon log (plain, .gz or .zst).

Each FLASER record, with its corrected pose,
becomes a tick with one range ray a beam; ODOM records are raw odometry in another frame and are only
counted. The bundle's parameters suit scans up to about a metre apart (of the Intel log: 0.67 m,
the median of all steps; it is printed for every log); change them with --set when certifying. S is a disc round the first pose; G is where you say, and without it there is the on-policy
corridor value but no certificate.

Usage: tcert import carmen LOG --output DIR [options]

Example:
  tcert import carmen intel.gfs.log.gz --output intel --goal-x -2 --goal-y -14.5 --goal-radius 1
  tcert certify intel --output results

Cost: one pass over the log.
)";

}  // namespace

CommandForm import_carmen_form() { return form_for<ImportCarmenRequest>(kText, "carmen"); }

int import_carmen_command(Arguments arguments) {
  return run_command(kText, arguments, import_carmen);
}

}  // namespace tcert::cli
