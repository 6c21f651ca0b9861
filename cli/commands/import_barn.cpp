#include "cli/runs/import_barn.hpp"

#include "cli/commands/import.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kImportBarnText =
    R"(Make a feature table from public outcomes of the BARN challenge.

Trials are the result text of the challenge's own runner (run.py appends a line a trial to out.txt:
world success collided timeout time nav_metric, blanks between, no header; the last word may be missing),
any number of files, the planner named by --planner or by the file (dwa_out.txt: dwa); or tables with a
header, trials.csv by planner or mlda_dated.csv by date.

One row a trial: planner (or the date of the first commit that holds it), world, success, collided,
timeout, time_s, and the difficulty metrics of the world: m1 distance to the closest obstacle, m2
average visibility, m3 dispersion, m4 characteristic dimension, m5 tortuosity, as published and, where
the file has them, normalised. Worlds from 300 on have moving obstacles and are left out, as are worlds
without metrics; all that is left out is counted. A failure is censored at its time_s. The planners
ros2_maity and mppi_ros2 ran on another port with other limits; --same-port leaves them out.

Usage: tcert import barn --trials FILE... --metrics FILE --output FILE [options]

Example:
  tcert import barn --trials res/*_out.txt --metrics difficulty_metrics.csv --output barn.csv
  tcert import barn --trials out.txt --planner mine --metrics difficulty_metrics.csv --output mine.csv
  tcert import barn --trials trials.csv --metrics difficulty_metrics.csv --planners dwa,lics_ki \
      --output two.csv

Cost: one pass over the files.
)";

}  // namespace

CommandForm import_barn_form() { return form_for<ImportBarnRequest>(kImportBarnText, "barn"); }

int import_barn_command(Arguments arguments) {
  return run_command(kImportBarnText, arguments, import_barn);
}

}  // namespace tcert::cli
