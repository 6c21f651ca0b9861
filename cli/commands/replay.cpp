#include "cli/runs/replay.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kReplayText =
    R"(Drive the logged trials again at gated speed: same path, every interval re-timed by the margin.

Each trial is replayed at every law of --laws and beta of --betas, guards G1-G3 on; where neither is given and
a config file or a flag sets speed_law or beta_per_m, at that law alone. Where the law or
a guard halts over 5 cm of path or more the run stalls, and its success is lost; shorter stretches
are crept through.

With --output DIR: DIR/replay.csv (one row a trial, law and beta; 'hypotheses h3 --replays' reads
it), DIR/audit.csv (every guard that began or ceased to trip, with its cause), DIR/replay_totals.csv,
with --series DIR/series/<law>_<beta>/<trial_id>.csv (margins and speeds, tick by tick), what
'certify --no-series' writes, and DIR/manifest.json. Without it: the totals on stdout.

Usage: tcert replay BUNDLE [options]

Example:
  tcert replay corpus --output replays
  tcert replay corpus --trials 't00000*' --laws clip --betas 10 --replan --set guard_mode=watch

Cost: that of 'tcert certify', and about as much again with --replan.
)";

int run_replay(Arguments arguments) { return run_command(kReplayText, arguments, replay); }

std::vector<CommandForm> replay_forms() { return {form_for<ReplayRequest>(kReplayText)}; }

}  // namespace

const Command kReplay = {
    "replay", "drive logged trials again at gated speed", run_replay, replay_forms};

}  // namespace tcert::cli
