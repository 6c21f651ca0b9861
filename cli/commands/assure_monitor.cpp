#include "cli/runs/assure_monitor.hpp"

#include "cli/commands/assure.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kAssureMonitorText =
    R"(Watch rules over logged trials: what they detect, how often they cry wolf, what it costs.

Each rule is a formula over what a tick says (force, margins, staleness, ...) in past-time signal temporal
logic; 'tcert help rules' has the signals, the grammar and the default rules. It alarms at the ticks
at which it surely holds, as 'tcert live --monitor' and 'tcert drive' with +monitor do.

A trial with truth.csv ('tcert drive --truth') has unsafe episodes: times at which the body was driven at a
wall within its stopping way, or pressed harder than unsafe_force_n. Detection is stated beside false
alarms an hour, delay, and the share of the way that was driven under an alarm. Faults that
'tcert assure perturb' put in are judged too: which kind is seen by which rule.

Printed: what was found, a table by rule, a table by kind of fault. With --output DIR/ (it ends with /,
or is a folder) every table in every format, with episodes and alarms of each trial.

Usage: tcert assure monitor BUNDLE [options]

Example:
  tcert drive --policies M3 --worlds 20 --truth --output driven
  tcert assure perturb driven --wide-per-hour 20 --output faulty
  tcert assure monitor faulty --output assurance/

Cost: that of 'tcert certify', and a second for each thousand trials with truth.
)";

}  // namespace

CommandForm assure_monitor_form() {
  return form_for<AssureMonitorRequest>(kAssureMonitorText, "monitor");
}

int assure_monitor_command(Arguments arguments) {
  return run_command(kAssureMonitorText, arguments, assure_monitor);
}

}  // namespace tcert::cli
