#include "cli/runs/verify/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "cli/runs/thread_limit.hpp"
#include "cli/runs/verify/check_proofs.hpp"
#include "cli/runs/verify/make_again.hpp"
#include "cli/runs/verify/targets.hpp"
#include "reports/fit/cells.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

/// Files named of a result before the rest is counted.
constexpr std::size_t kNamed = 10;

Finding finding_of(const VerifyTarget& target,
                   const VerifyTree& tree,
                   const VerifyRequest& request,
                   Progress& progress) {
  if (request.files_only) {
    return {file_differences(target), {}, false};
  }
  Finding finding = made_again(target, tree.folder, request.inputs, progress);
  check_proofs(target, tree.folder, request.inputs, finding);
  return finding;
}

void say_finding(const Result& result, const Finding& finding, Progress& progress) {
  const std::string name = result.name == "." ? result.folder.string() : result.name;
  for (std::size_t i = 0; i < std::min(kNamed, finding.differences.size()); ++i) {
    progress.say(fmt::format("{}: {}", name, finding.differences[i]));
  }
  if (finding.differences.size() > kNamed) {
    progress.say(name + ": and " + std::to_string(finding.differences.size() - kNamed) + " more");
  }
  for (const std::string& obstacle : finding.obstacles) {
    progress.say(fmt::format("{}: {}", name, obstacle));
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
      "Stands: yes if every file is, byte for byte, what its manifest lists and, where it was made "
      "again, what is made, and if every proof in it stands; otherwise no."};
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

void say_other_tool(const VerifyTree& tree, Progress& progress) {
  for (const VerifyTarget& target : tree.targets) {
    const Result& result = target.result;
    if (result.manifest.tool_version != tool_version() ||
        result.manifest.tool_commit != tool_commit()) {
      progress.sum_up("'" + result.name + "' was made by version " + result.manifest.tool_version +
                      ", commit " + result.manifest.tool_commit + "; this is " +
                      std::string(tool_version()) + ", " + std::string(tool_commit()));
      return;
    }
  }
}

/// \throws NoInput for a place of --inputs that is not there: a misspelt one would hide the inputs.
void require_places(const std::vector<std::string>& places) {
  for (const std::string& place : places) {
    std::error_code error;
    if (!std::filesystem::exists(place, error)) {
      throw NoInput("--inputs: there is no '" + place + "', neither a file nor a folder");
    }
  }
}

}  // namespace

OptionTable options_of(VerifyRequest& request) {
  OptionTable table(request.given);
  table.argument({"RESULTS", &request.results, true, OptionRole::input});
  table.add("inputs", request.inputs, "PATH", "an input, or a folder that holds some; repeatable");
  table.add("files-only",
            request.files_only,
            "only compare the files with their digests, make nothing again and check no witness");
  add_common(table, request);
  return table;
}

ExitCode verify(const VerifyRequest& request, Progress& progress) {
  require_places(request.inputs);
  VerifyTree tree;
  try {
    tree = verify_tree(request.results);
  } catch (const MissingResult& error) {
    throw NoInput(error.what());
  }
  const ThreadLimit limit(request.threads);
  if (!request.files_only) {
    say_other_tool(tree, progress);
  }
  Table table = verdicts_table();
  table.synthetic = tree.synthetic;
  bool differs = !tree.uncovered.empty();
  bool missing = false;
  for (const VerifyTarget& target : tree.targets) {
    const Finding finding = finding_of(target, tree, request, progress);
    say_finding(target.result, finding, progress);
    differs = differs || !finding.differences.empty();
    missing = missing || !finding.obstacles.empty();
    table.add_row(verdict(target.result, finding));
  }
  for (const std::string& name : tree.uncovered) {
    progress.say("'" + name + "' is no result: no manifest covers it");
  }
  progress.show(shown(table, request.output, progress));
  return differs ? exit_differences : missing ? exit_no_input : exit_done;
}

}  // namespace tcert::cli
