#include "cli/runs/certify.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kCertifyText =
    R"(Certify the trials of a bundle: the certificate at every tick, and each trial's features.

With --output DIR: DIR/series/<trial_id>.csv (one row a tick), DIR/edges/<trial_id>.csv (one row an
edge of the corridor graph), DIR/features.csv and DIR/certificates.csv (one row a trial), the tables
of the study (table1, speed, study_cells) in every format, DIR/diagnostics.csv, DIR/manifest.json.
Without it: the features on stdout.

The ticks of synthetic logs (--ticks) begin with a line '# ...' that says so. pandas reads them by
read_csv(FILE, comment='#'). R reads them by read.csv(FILE, comment.char = '#').

--witness also looks for a path through what each run felt, and writes it with the margin that it
proves, and what that rests on, into DIR/witness/<trial_id>.json; 'clearance=witness' takes T_t from
it (lib/witness/README.md). It costs about 60 ms a trial. --witness-edges proves each edge of the
corridor graph by a path of its own too, in failed trials as well: such paths chain at the nodes. It
costs about 2 ms an edge more.

Last it says in how many successes and failures a certificate was issued, why not if in none, and a
line for each sign that values are not what their columns say: degrees in radians, millimetres, grams,
another frame, a dead sensor, a run beside its course (each trial's in DIR/diagnostics.csv).

Usage: tcert certify BUNDLE [options]

Example:
  tcert certify corpus --output results
  tcert certify corpus --set clearance=witness --witness --output proven
  tcert certify corpus --witness-edges --output edges
  tcert certify corpus --trials 't00000*' --set memory_weight_m=0 --format csv

Cost: one pass over the logs, a few trials in memory at a time; the series take about as much space
as logs at 20 Hz (--no-series leaves them out).
)";

int run_certify(Arguments arguments) { return run_command(kCertifyText, arguments, certify); }

std::vector<CommandForm> certify_forms() { return {form_for<CertifyRequest>(kCertifyText)}; }

}  // namespace

const Command kCertify = {
    "certify", "certify the trials of a bundle, tick by tick", run_certify, certify_forms};

}  // namespace tcert::cli
