#include "cli/runs/verify/verify.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kVerifyText =
    R"(Do these results stand? Makes them again from their inputs and compares every byte.

RESULTS is a folder with a manifest.json, a folder of such folders, as 'tcert reproduce' makes, or a
file with a FILE.manifest.json beside it. Each command is run again with the arguments that its
manifest keeps, into a scratch folder; every file it writes, and what the manifest says of parameters,
options, seed, origin and digests, is compared. With --files-only every file is compared with the digest
in its manifest, no more. A command line is run only if it is one that this tool writes into a
manifest, so results of strangers can be verified: nothing is written but below the scratch folder.
Witnesses (certify --witness) are also checked without the search that found them: what the log proves
free is built again from the log, and each path measured.
What no manifest covers and no result has as its input is named. Inputs are
looked for beside the results, in the current folder, and where --inputs says.

Exit code: 0 if all stands, 1 if something does not, 66 if something cannot be made
again because its inputs are not found; 71 if the system has too little memory or descriptors and 73
if no scratch folder can be made (TMPDIR): then nothing is known.

Usage: tcert verify RESULTS [options]

Example:
  tcert verify results
  tcert verify results --inputs /data/my-logs
  tcert verify results --files-only

Cost: that of the commands; without making anything again, of reading the files once.
)";

int run_verify(Arguments arguments) { return run_command(kVerifyText, arguments, verify); }

std::vector<CommandForm> verify_forms() { return {form_for<VerifyRequest>(kVerifyText)}; }

}  // namespace

const Command kVerify = {
    "verify", "make results again and compare every byte", run_verify, verify_forms};

}  // namespace tcert::cli
