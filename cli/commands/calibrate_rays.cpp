#include "cli/runs/calibrate_rays.hpp"

#include "cli/commands/calibrate.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCalibrateRaysText =
    R"(Calibrate rays: from bends beside measured clearances to a curve with a lower bound.

PAIRS is a table with the columns ray, run, day, bend_rad, clearance_m, a row a tick: the bend as ticks
have it (the median of three samples, which takes glitches away), and the clearance in the direction of
the ray as something else measured it (a ruler, motion capture, a map).
Each ray gets a monotone curve (isotonic regression in the direction that the data have, a few knots).
Curve - q is a lower bound: at all ticks and rays of a new day with probability 1 - alpha or more,
whatever the curve is (split conformal prediction). Its unit is the day, for trials of a day share a
bias: some days, drawn by --seed, give the curves; the others give q, the rank ceil((n + 1)(1 - alpha))
among the most by which a curve overstates on each of these n days. For alpha 0.05 that takes 19 days
and one for the curves; with fewer nothing is given (exit code 65) unless --no-bound is: the curves alone.

Printed: the knots, how each curve was fitted, what each day scored, and the list 'rays' to be pasted
into bundle.json. With --output DIR/ (it ends with /, or is a folder) every table in every format, and
that list as rays.json. Another PATH is one file of what would be printed, in --format.

Usage: tcert calibrate rays PAIRS [options]

Example:
  tcert calibrate rays pairs.csv --bundle logs --output calibration/
  tcert calibrate rays pairs.csv --alpha 0.1
  tcert calibrate rays bench.csv --no-bound

Cost: a second for a million pairs.
)";

}  // namespace

CommandForm calibrate_rays_form() {
  return form_for<CalibrateRaysRequest>(kCalibrateRaysText, "rays");
}

int calibrate_rays_command(Arguments arguments) {
  return run_command(kCalibrateRaysText, arguments, calibrate_rays);
}

}  // namespace tcert::cli
