#include "cli/runs/calibrate_tracking.hpp"

#include "cli/commands/calibrate.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCalibrateTrackingText =
    R"(Calibrate tracking: how far a robot strays from its path, from runs or from a model.

RUNS is a table with the columns run, time_s, x_m, y_m, yaw_rad (as it drove), nominal_x_m, nominal_y_m (as
it was to drive), and if they are known day, curvature_per_m, nominal_curvature_per_m; a row a sample.
tracking_buffer_m is the largest distance from the nominal path, a polyline, of which the stretch
within --lag-s of the sample's time counts; curvature_buffer_per_m the largest difference from the
nominal curvature at the same time. Curvatures that are not stated are told over the last --window-m of travel.
What the largest of n runs bounds is said with it (Wilks): 59 independent runs bound 95 % of all runs with
95 % confidence.

--model double-integrator gives a table speed_mps, speed_left_mps, disturbance, radius_m, hold_s for
--tracking-error instead: the radius of the greater of both speeds, and how long that of the speed just left
goes on holding. Disturbance 1 is the whole one, 0 none.

With --output DIR/ (it ends with /, or is a folder) every table in every format and, of runs, buffers.ini,
which --config takes as it is, and robot.json, for the 'robot' of bundle.json. Another PATH is one
file of what would be printed, in --format.

Usage: tcert calibrate tracking RUNS [options]
       tcert calibrate tracking --model double-integrator [options]

Example:
  tcert calibrate tracking runs.csv --output buffers/
  tcert certify logs --config buffers/buffers.ini --output results
  tcert calibrate tracking --model double-integrator --braking-mps2 0.8 --disturbance-mps2 0.1 \
    --format csv --output tracking.csv

Cost: a second for a million samples at 10 Hz.
)";

}  // namespace

CommandForm calibrate_tracking_form() {
  return form_for<CalibrateTrackingRequest>(kCalibrateTrackingText, "tracking");
}

int calibrate_tracking_command(Arguments arguments) {
  return run_command(kCalibrateTrackingText, arguments, calibrate_tracking);
}

}  // namespace tcert::cli
