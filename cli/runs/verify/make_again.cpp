#include "cli/runs/verify/make_again.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/path_name.hpp>
#include <table/regular_file.hpp>
#include <utility>

#include "cli/runs/errors.hpp"
#include "cli/runs/scratch_folder.hpp"
#include "cli/runs/verify/compare.hpp"
#include "cli/runs/verify/find_input.hpp"
#include "cli/runs/verify/rerun.hpp"
#include "reports/manifest_checks.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

/// True if the tree holds every manifest that a page, or figures, of results list: whatever it was
/// called when they were made.
bool is_drawn_of(const VerifyTarget& target, const fs::path& results) {
  const WrittenResult& manifest = target.result.manifest;
  std::error_code error;
  return (manifest.command == "report" || manifest.command == "figures") &&
         !manifest.inputs.empty() &&
         std::all_of(
             manifest.inputs.begin(), manifest.inputs.end(), [&](const ManifestFile& input) {
               return table::leads_below(input.path) &&
                      fs::is_regular_file(results / input.path, error);
             });
}

/// The run that makes the result again; names what cannot be found. \throws NotReproducible.
Rerun found_rerun(const VerifyTarget& target,
                  const fs::path& results,
                  const std::vector<std::string>& inputs,
                  Finding& finding) {
  const auto find = [&](const std::string& name, bool first) -> std::optional<std::string> {
    if (first && is_drawn_of(target, results)) {
      return results.string();
    }
    const auto path = find_input(name, target, results, inputs);
    if (!path) {
      finding.obstacles.push_back("its input '" + name +
                                  "' cannot be found; name its place with --inputs");
      return std::nullopt;
    }
    return path->string();
  };
  return rerun_of(target.result.manifest, find);
}

/// Runs it; false, with the reason in the finding, if nothing came of it.
bool run_into(const Rerun& rerun, const fs::path& output, Progress& progress, Finding& finding) {
  OnlyWords words(progress);
  try {
    rerun(output.string(), words);
    return true;
  } catch (const NoInput& error) {
    finding.obstacles.push_back(std::string("it cannot be made again here: ") + error.what());
  } catch (const table::OutOfResources&) {
    throw;  // Nothing is known then.
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const table::WriteError& error) {
    finding.obstacles.push_back(std::string("it cannot be made again here: ") + error.what());
  } catch (const std::system_error& error) {
    finding.obstacles.push_back(std::string("it cannot be made again here: ") + error.what());
  } catch (const std::exception& error) {
    finding.differences.push_back(std::string("it cannot be made again: ") + error.what());
  }
  return false;
}

void compare_file(const VerifyTarget& target, const fs::path& again, Finding& finding) {
  const fs::path found = target.result.folder / target.file;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(found, error))) {
    finding.differences.push_back("'" + target.file + "' is missing");
  } else if (digest_file(found).sha256 != digest_file(again).sha256) {
    finding.differences.push_back("'" + target.file + "' is not what is made again");
  }
}

void make_and_compare(const VerifyTarget& target,
                      const fs::path& results,
                      const std::vector<std::string>& inputs,
                      Progress& progress,
                      Finding& finding) {
  const WrittenResult& manifest = target.result.manifest;
  if (!manifest.arguments) {
    finding.differences.push_back("it was written by another version (" + manifest.tool_version +
                                  ") and cannot be made again");
    return;
  }
  Rerun rerun;
  try {
    rerun = found_rerun(target, results, inputs, finding);
  } catch (const NotReproducible& error) {
    finding.differences.emplace_back(error.what());
    return;
  }
  if (!finding.obstacles.empty()) {
    return;
  }
  const ScratchFolder scratch;
  const fs::path again = scratch.path() / "again";
  const bool is_file = !target.file.empty();
  if (is_file) {
    fs::create_directory(again);
  }
  if (!run_into(rerun, again / target.file, progress, finding)) {
    return;
  }
  const auto now = read_manifest(is_file ? (again / target.file).string() + ".manifest.json"
                                         : (again / "manifest.json").string());
  if (!now) {
    finding.differences.emplace_back("it cannot be made again: nothing was written");
    return;
  }
  finding.made_again = true;
  if (is_file) {
    compare_file(target, again / target.file, finding);
  } else {
    finding.differences = compare_folders(target.result.folder, again);
  }
  for (std::string& difference : compare_manifests(manifest, *now)) {
    finding.differences.push_back(std::move(difference));
  }
  const fs::path written = manifest_path(target);
  if (!is_as_written(written, manifest)) {
    finding.differences.push_back("'" + written.filename().string() +
                                  "' holds more than what is read of it, or in another form");
  }
}

}  // namespace

Finding made_again(const VerifyTarget& target,
                   const fs::path& results,
                   const std::vector<std::string>& inputs,
                   Progress& progress) {
  Finding finding;
  make_and_compare(target, results, inputs, progress, finding);
  if (!finding.made_again) {
    for (std::string& difference : file_differences(target)) {
      finding.differences.push_back(std::move(difference));
    }
  }
  return finding;
}

}  // namespace tcert::cli
