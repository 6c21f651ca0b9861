#include "cli/runs/import_carmen.hpp"

#include "cli/commands/import.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kImportCarmenText =
    R"(Make a bundle from a Carnegie Mellon log (plain, .gz or .zst).

Each FLASER record (or ROBOTLASER1, by the first that the log has) becomes a tick with one range ray a
beam, at the pose of the record. ODOM records are only compared with those poses: where they lie on the
way of the odometry they are the odometry, not scan-matched, and that is said.

Beam i points to -90 degrees + i for 180 or 181 beams, + i/2 for 360 or 361, as in CARMEN's own reader;
other numbers need --fov. ROBOTLASER1 records state their angles, and where the laser is on the robot.
Stamps often carry no order (rounded to six digits, wrapped, zero): where nine of ten scans cannot be
used nothing is written (exit code 65); --clock order makes times from the order of the records.

The bundle's parameters suit scans up to about a metre apart (of the Intel log: 0.67 m,
the median of all steps; it is printed for every log); change them with --set when certifying. S is a disc round the first pose; G is where you say, and without it there is the on-policy
corridor value but no certificate.

Usage: tcert import carmen LOG --output DIR [options]

Example:
  tcert import carmen intel.gfs.log.gz --output intel --goal-x -2 --goal-y -14.5 --goal-radius 1
  tcert certify intel --output results
  tcert import carmen belgioioso-corrected.log.gz --output belgioioso --clock order --rate 0.5

Cost: one pass over the log.
)";

}  // namespace

CommandForm import_carmen_form() {
  return form_for<ImportCarmenRequest>(kImportCarmenText, "carmen");
}

int import_carmen_command(Arguments arguments) {
  return run_command(kImportCarmenText, arguments, import_carmen);
}

}  // namespace tcert::cli
