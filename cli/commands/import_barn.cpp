#include "cli/runs/import_barn.hpp"

#include "cli/commands/import.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a feature table from public outcomes of the BARN challenge.

One row a trial: planner (or the date of the first commit that holds it), world, success, collided,
timeout, time_s, and the difficulty metrics of the world: m1 distance to the closest obstacle, m2
average visibility, m3 dispersion, m4 characteristic dimension, m5 tortuosity, as published and, where
the file has them, normalised. Worlds from 300 on have moving obstacles and are left out, as are worlds
without metrics; all that is left out is counted. A failure is censored at its time_s. The planners
ros2_maity and mppi_ros2 ran on another port with other limits; --same-port leaves them out.

Usage: tcert import barn --trials FILE --metrics FILE --output FILE [options]

Example:
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --output barn.csv
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --planners dwa,lics_ki \
      --output two.csv

Cost: one pass over the files.
)";

}  // namespace

CommandForm import_barn_form() { return form_for<ImportBarnRequest>(kText, "barn"); }

int import_barn_command(Arguments arguments) { return run_command(kText, arguments, import_barn); }

}  // namespace tcert::cli
