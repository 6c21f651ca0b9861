#include "cli/runs/experiment/cells.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kAblateText =
    R"(Leave parts of the method out and see what that does to H1 and to the issuing of certificates.

The cells: A1 no contact memory, A2 unknown space taken for free, A3 no curvature, their pairs and
all three; of logs with slope, step or slip A4, the plane alone; or those of --cells. Each beside the full method: change of AUC and C on the same trials in
the same resamples, its own gain over its strongest rival, spurious certificates.

With --output DIR: DIR/cells.*, DIR/issuance.*, DIR/speed.* (H3; CSV, JSON, text, Markdown, LaTeX), DIR/features/*.csv and
DIR/replays/*.csv (DIR/files.csv says which cell has which), DIR/manifest.json. Without it: the table on stdout.

Usage: tcert ablate BUNDLE [options]

Example:
  tcert ablate corpus
  tcert ablate corpus --table issuance --format md
  tcert ablate corpus --cells cells.csv --output ablation

Cost: that of 'tcert certify' for each cell that changes the series, less what the cache holds; then
about a second a cell.
)";

int run_ablate(Arguments arguments) { return run_command(kAblateText, arguments, ablate); }

std::vector<CommandForm> ablate_forms() { return {form_for<AblateRequest>(kAblateText)}; }

}  // namespace

const Command kAblate = {
    "ablate", "leave parts of the method out, beside the full one", run_ablate, ablate_forms};

}  // namespace tcert::cli
