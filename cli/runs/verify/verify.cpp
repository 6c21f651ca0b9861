#include <tbb/global_control.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/verify/make_again.hpp"
#include "cli/verify/targets.hpp"
#include "reports/fit/cells.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Do these results stand? Makes them again from their inputs and compares every byte.

RESULTS is a folder with a manifest.json, a folder of such folders, as 'tcert reproduce' makes, or a
file with a FILE.manifest.json beside it. Each command is run again with the arguments that its
manifest keeps, into a scratch folder; every file it writes, and what the manifest says of parameters,
options, seed, origin and digests, is compared. With --files-only every file is compared with the digest
in its manifest, no more. A command line is run only if it is one that this tool writes into a
manifest, so results of strangers can be verified: nothing is written but below the scratch folder.
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

/// Files named of a result before the rest is counted.
constexpr std::size_t kNamed = 10;

struct VerifyOptions {
  std::string results;
  std::vector<std::string> inputs;
  bool files_only = false;
};

Finding finding_of(const VerifyTarget& target,
                   const VerifyTree& tree,
                   const VerifyOptions& options) {
  if (options.files_only) {
    return {file_differences(target), {}, false};
  }
  return made_again(target, tree.folder, options.inputs);
}

void say_finding(const Result& result, const Finding& finding) {
  const std::string name = result.name == "." ? result.folder.string() : result.name;
  for (std::size_t i = 0; i < std::min(kNamed, finding.differences.size()); ++i) {
    say(name + ": " + finding.differences[i]);
  }
  if (finding.differences.size() > kNamed) {
    say(name + ": and " + std::to_string(finding.differences.size() - kNamed) + " more");
  }
  for (const std::string& obstacle : finding.obstacles) {
    say(name + ": " + obstacle);
  }
}

Table verdicts_table() {
  Table table;
  table.name = "verify";
  table.title = "Do the results stand?";
  table.columns = {text_column("result", "result"),
                   text_column("command", "command"),
                   integer_column("files", "files"),
                   integer_column("bytes", "bytes"),
                   text_column("made_again", "made again"),
                   integer_column("differences", "differences"),
                   text_column("stands", "stands")};
  table.footnotes = {
      "stands: every file is, byte for byte, what its manifest lists"
      " and, where it was made again, what is made."};
  return table;
}

std::vector<TableCell> verdict(const Result& result, const Finding& finding) {
  FileDigest sum;
  for (const ManifestFile& file : result.manifest.outputs) {
    sum.files += file.digest.files;
    sum.bytes += file.digest.bytes;
  }
  const bool unknown = finding.differences.empty() && !finding.obstacles.empty();
  return {result.name,
          result.manifest.command,
          integer_cell(sum.files),
          integer_cell(sum.bytes),
          std::string(finding.made_again ? "yes" : "no"),
          integer_cell(finding.differences.size()),
          unknown ? TableCell{} : yes_or_no_cell(finding.differences.empty())};
}

void say_other_tool(const VerifyTree& tree) {
  for (const VerifyTarget& target : tree.targets) {
    const Result& result = target.result;
    if (result.manifest.tool_version != tool_version() ||
        result.manifest.tool_commit != tool_commit()) {
      say("'" + result.name + "' was made by version " + result.manifest.tool_version +
          ", commit " + result.manifest.tool_commit + "; this is " + std::string(tool_version()) +
          ", " + std::string(tool_commit()));
      return;
    }
  }
}

int run(Arguments arguments) {
  VerifyOptions options;
  CommonOptions common;
  CommandLine line{"verify",
                   kText,
                   uses_format | uses_threads,
                   po::options_description("Options"),
                   {{"RESULTS", &options.results, true, OptionRole::input}}};
  line.own.add_options()("inputs",
                         po::value(&options.inputs)->composing()->value_name("PATH"),
                         "an input, or a folder that holds some; repeatable")(
      "files-only",
      po::bool_switch(&options.files_only),
      "only compare the files with their digests, make nothing again");
  if (!parse(line, common, arguments)) {
    return exit_done;
  }
  VerifyTree tree;
  try {
    tree = verify_tree(options.results);
  } catch (const MissingResult& error) {
    throw NoInput(error.what());
  }
  std::optional<tbb::global_control> limit;
  if (common.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(common.threads));
  }
  if (!common.quiet && !options.files_only) {
    say_other_tool(tree);
  }
  Table table = verdicts_table();
  table.synthetic = tree.synthetic;
  bool differs = !tree.uncovered.empty();
  bool missing = false;
  for (const VerifyTarget& target : tree.targets) {
    const Finding finding = finding_of(target, tree, options);
    say_finding(target.result, finding);
    differs = differs || !finding.differences.empty();
    missing = missing || !finding.obstacles.empty();
    table.add_row(verdict(target.result, finding));
  }
  for (const std::string& name : tree.uncovered) {
    say("'" + name + "' is no result: no manifest covers it");
  }
  print(render(table, common.table_format()));
  return differs ? exit_differences : missing ? exit_no_input : exit_done;
}

}  // namespace

const Command kVerify = {"verify", "make results again and compare every byte", run};

}  // namespace tcert::cli
