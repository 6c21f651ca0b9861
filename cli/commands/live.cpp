#include "cli/runs/live/live.hpp"

#include "cli/commands/live_terrain.hpp"
#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kLiveText =
    R"(Certify ticks as they arrive: reads ticks, writes one row of the series per tick, at once.

The rows are those that 'certify' writes for the same ticks, byte for byte; with --guards those that
'replay --series' writes, with the speed v_t and the guards G1-G3 at the end. A line that is not a
tick is reported on stderr and skipped; the exit code is then 3.

Ticks come from stdin, or with --listen from one producer after the other on a Unix socket, or as
datagrams of whole lines on UDP, which only this machine can send. A producer that comes back
begins with a header again (or with JSON); its first tick is a break of the path. Its times go on: a
tick that is not after the last one, as of a clock that begins at 0 again, is skipped as a bad line.

--record DIR writes the ticks as a bundle with one trial, which 'certify' reads back to the same
series. It appears when the run ends, by the end of the input, SIGINT or SIGTERM; until then, and
if the process is killed, it is the hidden folder .DIR.*.tmp beside it, which can be read as well.

--audit FILE writes one row for every guard that began or ceased to trip, with its cause, at once.
FILE must not be there, or be an audit log of an earlier run. When a disk is full, that of the audit,
of the record or of the rows, the run goes on: that is said once, what is lost is counted, and the
exit code is 73.

Usage: tcert live --bundle BUNDLE [options] < ticks
       tcert live terrain [LAYOUT] [options] < measurements   (see 'tcert live terrain --help')

Example:
  robot_driver | tcert live --bundle results/corpus/bundle.json
  tcert live --bundle corpus --input-format jsonl --set beta_per_m=20 < ticks.jsonl
  robot_driver | tcert live --bundle corpus --guards --audit audit.csv --set speed_law=clip
  tcert live --bundle corpus --listen unix:/run/ticks --record run17
  tcert live --bundle corpus --listen udp:5005 --stale-after 0.5 > series.csv

With --set clearance=witness --set witness_every=50 a thread of its own looks for a path that proves a
margin every 50 ticks, and T_t is the best so far; what the whole run proves is said at the end.

Cost: about a microsecond of certifying per tick; memory does not grow with the run, but by some 100
bytes a tick for witnesses, up to a million ticks.
)";

int run_live(Arguments arguments) {
  if (!arguments.empty() && arguments.front() == "terrain") {
    return live_terrain_command(arguments.subspan(1));
  }
  return run_command(kLiveText, arguments, live);
}

std::vector<CommandForm> live_forms() {
  return {form_for<LiveRequest>(kLiveText), live_terrain_form()};
}

}  // namespace

const Command kLive = {"live", "certify ticks as they arrive", run_live, live_forms};

}  // namespace tcert::cli
