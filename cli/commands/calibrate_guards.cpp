#include "cli/runs/calibrate_guards.hpp"

#include "cli/commands/calibrate.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCalibrateGuardsText =
    R"(Fit a speed law and the guards' thresholds to driven trials, and judge them on other days.

BUNDLE has truth.csv ('tcert drive --truth'). Each choice of law, beta, epsilon and F_min is replayed along the
logged paths; chosen is the one with the least unsafe dwell (time driven at a wall within the stopping way,
unsafe_brake_mps2 and unsafe_reaction_s) among those that keep 1 - P of the unguarded
progress and let at most P of the trials stall. Where guards halt, the way is driven at the least speed and
counts as safe; over stall_m of it the trial has stalled. Choices are made on folds of whole days and
judged on the days left out; the front, every choice and the best one as a config file are printed. epsilon
also comes with a promise for a new day, by conformal risk control.

A log says nothing of what the robot does after a halt: 'tcert drive' with +guards does.

Usage: tcert calibrate guards BUNDLE [options]

Example:
  tcert drive --policies M3 --worlds 40 --truth --output driven
  tcert calibrate guards driven --output guards/
  tcert replay driven --config guards/guards.ini

Cost: that of 'tcert certify', and 0.1 s for each choice and 100 trials.
)";

}  // namespace

CommandForm calibrate_guards_form() {
  return form_for<CalibrateGuardsRequest>(kCalibrateGuardsText, "guards");
}

int calibrate_guards_command(Arguments arguments) {
  return run_command(kCalibrateGuardsText, arguments, calibrate_guards);
}

}  // namespace tcert::cli
