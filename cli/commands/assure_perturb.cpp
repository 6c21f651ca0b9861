#include "cli/runs/assure_perturb.hpp"

#include "cli/commands/assure.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kAssurePerturbText =
    R"(Put faults into the logs of a bundle: a bundle like it, and injections.csv, which lists them.

Six kinds, each by an option of its own: dropouts (good and bad times of a stream by turns,
Gilbert-Elliott), bursts of latency (arrival_s), spikes of force, rays that freeze, rays that are stuck at a
wide reading, biased rays. Without any the bundle comes out as it was.

Each kind of each stream of each trial has draws of its own, by --seed: they stay the same whatever else is
asked for, and whatever trials there are. Dropouts begin in the stationary state; the others begin at
a rate per hour of the trial's time, and one that would not be over by its end does not begin. The first
and the last sample of a stream are never lost, so that ticks stay where they are. What no fault met, a
file, a row, a cell, is the same bytes. Times are never changed.

In ticks.csv, ticks that were merged before, a loss empties the rays of a tick, which is stale then;
latency is refused (exit code 3; the trial is copied). Rejected trials are copied.

Usage: tcert assure perturb BUNDLE --output DIR [options]

Example:
  tcert assure perturb driven --wide-per-hour 20 --output stuck
  tcert assure perturb logs --dropout-good-s 60 --dropout-bad-s 2 --streams tactile --output lossy
  tcert assure perturb logs --spikes-per-hour 60 --spike-n 15 --bursts-per-hour 30 --output noisy

Then: tcert certify stuck --output results

Cost: one pass over the logs.
)";

}  // namespace

CommandForm assure_perturb_form() {
  return form_for<AssurePerturbRequest>(kAssurePerturbText, "perturb");
}

int assure_perturb_command(Arguments arguments) {
  return run_command(kAssurePerturbText, arguments, assure_perturb);
}

}  // namespace tcert::cli
