#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/scratch_folder.hpp"
#include "reports/fit/cells.hpp"
#include "reports/results/results.hpp"
#include "reports/version.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kText =
    R"(Do these results stand? Makes them again from their inputs and compares every byte.

RESULTS is a folder with a manifest.json, or a folder of such folders, as 'tcert reproduce' makes.
First every file is compared with the digest in its manifest: one that is missing, was added or was
changed is named. Then each command is run again with the arguments that its manifest keeps, into a
scratch folder, and every file it writes is compared. Inputs are looked for beside the results, in the
current folder, and where --inputs says.

Exit code: 0 if all stands, 1 if something does not, 66 if inputs cannot be found.

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

/// What was found of one result.
struct Finding {
  std::vector<std::string> differences;
  std::vector<std::string> missing_inputs;
  bool made_again = false;
};

/// The file or folder of an input's name: where --inputs says, beside the results, or here. Of
/// several the one with the digest.
std::optional<fs::path> find_input(const std::string& name,
                                   const Result& result,
                                   const Results& results,
                                   const VerifyOptions& options) {
  std::vector<fs::path> candidates;
  for (const fs::path path : options.inputs) {
    if (name_of(path) == name) {
      candidates.push_back(path);
    }
    candidates.push_back(path / name);
  }
  const fs::path folder = fs::weakly_canonical(results.folder);
  for (const fs::path& beside : {folder, folder.parent_path()}) {
    candidates.push_back(beside / name);
    if (beside == folder || result.name == ".") {
      std::vector<fs::path> parts;
      for (const auto& entry : fs::directory_iterator(beside)) {
        if (entry.is_directory()) {
          parts.push_back(entry.path() / name);
        }
      }
      std::sort(parts.begin(), parts.end());
      candidates.insert(candidates.end(), parts.begin(), parts.end());
    }
  }
  candidates.emplace_back(name);
  std::error_code error;
  std::erase_if(candidates, [&](const fs::path& path) { return !fs::exists(path, error); });
  for (const fs::path& path : candidates) {
    for (const ManifestFile& input : result.manifest.inputs) {
      if (input.path == name && fs::is_regular_file(path, error) &&
          digest_file(path).sha256 == input.digest.sha256) {
        return path;
      }
    }
  }
  return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) {
      files.insert(entry.path().lexically_relative(folder).generic_string());
    }
  }
  files.erase("manifest.json");
  return files;
}

/// Names of files that are not the same in both folders.
std::vector<std::string> compare(const fs::path& found, const fs::path& again) {
  const std::set<std::string> first = files_in(found);
  const std::set<std::string> second = files_in(again);
  std::vector<std::string> differences;
  for (const std::string& file : second) {
    if (first.count(file) == 0) {
      differences.push_back("'" + file + "' is missing");
    } else if (digest_file(found / file).sha256 != digest_file(again / file).sha256) {
      differences.push_back("'" + file + "' is not what is made again");
    }
  }
  for (const std::string& file : first) {
    if (second.count(file) == 0) {
      differences.push_back("'" + file + "' is not made again");
    }
  }
  return differences;
}

/// Inputs with another digest than those that the result was made of.
std::vector<std::string> changed_inputs(const WrittenResult& then, const WrittenResult& now) {
  std::vector<std::string> changed;
  for (const ManifestFile& input : then.inputs) {
    const bool same =
        std::any_of(now.inputs.begin(), now.inputs.end(), [&](const ManifestFile& one) {
          return one.path == input.path && one.digest.sha256 == input.digest.sha256;
        });
    if (!same) {
      changed.push_back("its input '" + input.path + "' has changed since");
    }
  }
  return changed;
}

const Command* command_called(const std::string& name) {
  for (const Command* command : commands()) {
    if (command->name == name) {
      return command;
    }
  }
  return nullptr;
}

/// The command line that makes the result again; names what cannot be found.
std::vector<std::string> words_of(const Result& result,
                                  const Results& results,
                                  const VerifyOptions& options,
                                  const CommonOptions& common,
                                  Finding& finding) {
  std::vector<std::string> words;
  for (const ManifestArgument& argument : *result.manifest.arguments) {
    if (!argument.is_input) {
      words.push_back(argument.text);
    } else if (const auto path = find_input(argument.text, result, results, options)) {
      words.push_back(path->string());
    } else {
      finding.missing_inputs.push_back(argument.text);
    }
  }
  words.insert(words.end(), {"--threads", std::to_string(common.threads), "--quiet"});
  if (result.kind == ResultKind::ablation || result.kind == ResultKind::sweep) {
    words.emplace_back("--no-cache");
  }
  return words;
}

void make_again(const Result& result,
                const Results& results,
                const VerifyOptions& options,
                const CommonOptions& common,
                Finding& finding) {
  const Command* const command = command_called(result.manifest.command);
  if (command == nullptr || !result.manifest.arguments) {
    finding.differences.push_back("it was written by another version (" +
                                  result.manifest.tool_version + ") and cannot be made again");
    return;
  }
  std::vector<std::string> words = words_of(result, results, options, common, finding);
  if (!finding.missing_inputs.empty()) {
    return;
  }
  const ScratchFolder scratch;
  const fs::path again = scratch.path() / "again";
  words.insert(words.end(), {"--output", (again / "").string()});
  try {
    command->run(words);
  } catch (const std::exception& error) {
    finding.differences.push_back(std::string("it cannot be made again: ") + error.what());
    return;
  }
  const auto now = read_manifest(again / "manifest.json");
  if (!now) {
    finding.differences.emplace_back("it cannot be made again: nothing was written");
    return;
  }
  finding.made_again = true;
  finding.differences = changed_inputs(result.manifest, *now);
  const std::vector<std::string> files = compare(result.folder, again);
  finding.differences.insert(finding.differences.end(), files.begin(), files.end());
}

Finding finding_of(const Result& result,
                   const Results& results,
                   const VerifyOptions& options,
                   const CommonOptions& common) {
  Finding finding;
  if (!options.files_only) {
    make_again(result, results, options, common, finding);
  }
  if (!finding.made_again) {
    for (const FileDifference& one : differences(result.folder, result.manifest)) {
      finding.differences.push_back("'" + one.path + "' " + std::string(to_string(one.change)));
    }
  }
  return finding;
}

void say_finding(const Result& result, const Finding& finding) {
  const std::string name = result.name == "." ? result.folder.string() : result.name;
  for (std::size_t i = 0; i < std::min(kNamed, finding.differences.size()); ++i) {
    say(name + ": " + finding.differences[i]);
  }
  if (finding.differences.size() > kNamed) {
    say(name + ": and " + std::to_string(finding.differences.size() - kNamed) + " more");
  }
  for (const std::string& input : finding.missing_inputs) {
    say(name + ": its input '" + input + "' cannot be found; name its place with --inputs");
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
  const bool unknown = finding.differences.empty() && !finding.missing_inputs.empty();
  return {result.name,
          result.manifest.command,
          integer_cell(sum.files),
          integer_cell(sum.bytes),
          std::string(finding.made_again ? "yes" : "no"),
          integer_cell(finding.differences.size()),
          unknown ? TableCell{} : yes_or_no_cell(finding.differences.empty())};
}

void say_other_tool(const Results& results) {
  for (const Result& result : results.all) {
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
                   {{"RESULTS", &options.results}}};
  line.own.add_options()("inputs",
                         po::value(&options.inputs)->composing()->value_name("PATH"),
                         "an input, or a folder that holds some; repeatable")(
      "files-only",
      po::bool_switch(&options.files_only),
      "only compare the files with their digests, make nothing again");
  if (!parse(line, common, arguments)) {
    return exit_done;
  }
  Results results;
  try {
    results = read_results(options.results);
  } catch (const MissingResult& error) {
    throw NoInput(error.what());
  }
  if (!common.quiet && !options.files_only) {
    say_other_tool(results);
  }
  Table table = verdicts_table();
  table.synthetic = results.synthetic;
  bool differs = false;
  bool missing = false;
  for (const Result& result : results.all) {
    const Finding finding = finding_of(result, results, options, common);
    say_finding(result, finding);
    differs = differs || !finding.differences.empty();
    missing = missing || !finding.missing_inputs.empty();
    table.add_row(verdict(result, finding));
  }
  print(render(table, common.table_format()));
  return differs ? exit_differences : missing ? exit_no_input : exit_done;
}

}  // namespace

const Command kVerify = {"verify", "make results again and compare every byte", run};

}  // namespace tcert::cli
