#include "cli/runs/verify/targets.hpp"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <table/path_name.hpp>
#include <utility>

#include "reports/manifest_checks.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kManifest = "manifest.json";
constexpr std::string_view kFileManifest = ".manifest.json";

VerifyTarget file_target(const fs::path& file) {
  auto manifest = read_manifest(file.string() + std::string(kFileManifest));
  if (!manifest) {
    throw MissingResult(why_no_manifest(file.string() + std::string(kFileManifest)));
  }
  const std::string name = file.filename().string();
  return {{ResultKind::other, file.parent_path(), name, std::move(*manifest)}, name};
}

struct Entries {
  std::vector<std::string> folders;
  std::vector<std::string> files;
};

Entries entries_of(const fs::path& folder) {
  Entries entries;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (table::is_temporary_name(entry.path().filename().native())) {
      continue;
    }
    (entry.is_directory() ? entries.folders : entries.files)
        .push_back(entry.path().filename().string());
  }
  std::sort(entries.folders.begin(), entries.folders.end());
  std::sort(entries.files.begin(), entries.files.end());
  return entries;
}

bool is_input(const VerifyTree& tree, const std::string& name) {
  return std::any_of(tree.targets.begin(), tree.targets.end(), [&](const VerifyTarget& target) {
    const auto& arguments = target.result.manifest.arguments;
    return arguments &&
           std::any_of(arguments->begin(), arguments->end(), [&](const ManifestArgument& argument) {
             return argument.is_input && argument.text == name;
           });
  });
}

void find_uncovered(const Entries& entries, VerifyTree& tree) {
  const auto is_target = [&](const std::string& name, bool file) {
    return std::any_of(tree.targets.begin(), tree.targets.end(), [&](const VerifyTarget& target) {
      return target.file.empty() != file &&
             (target.result.name == name ||
              (file && target.file + std::string(kFileManifest) == name));
    });
  };
  for (const std::string& name : entries.folders) {
    if (!is_target(name, false) && !is_input(tree, name)) {
      tree.uncovered.push_back(name + "/");
    }
  }
  for (const std::string& name : entries.files) {
    if (!is_target(name, true) && !is_input(tree, name)) {
      tree.uncovered.push_back(name);
    }
  }
}

}  // namespace

VerifyTree verify_tree(const fs::path& path) {
  VerifyTree tree;
  std::error_code error;
  if (!fs::is_directory(path, error) &&
      fs::is_regular_file(path.string() + std::string(kFileManifest), error)) {
    tree.folder = fs::absolute(path).parent_path();
    tree.targets.push_back(file_target(fs::absolute(path)));
    tree.synthetic = tree.targets[0].result.manifest.synthetic;
    return tree;
  }
  tree.folder = path;
  Entries entries;
  if (fs::is_directory(path, error) && !fs::is_regular_file(path / kManifest, error)) {
    entries = entries_of(path);
  }
  std::vector<VerifyTarget> files;
  for (const std::string& name : entries.files) {
    if (name.size() > kFileManifest.size() && name.ends_with(kFileManifest)) {
      files.push_back(file_target(path / name.substr(0, name.size() - kFileManifest.size())));
    }
  }
  const bool has_folders =
      std::any_of(entries.folders.begin(), entries.folders.end(), [&](const std::string& name) {
        return fs::is_regular_file(path / name / kManifest, error);
      });
  if (files.empty() || has_folders) {
    Results results = read_results(path);
    tree.synthetic = results.synthetic;
    for (Result& result : results.all) {
      tree.targets.push_back({std::move(result), ""});
    }
  }
  for (VerifyTarget& target : files) {
    if (!tree.synthetic) {
      tree.synthetic = target.result.manifest.synthetic;
    }
    tree.targets.push_back(std::move(target));
  }
  find_uncovered(entries, tree);
  return tree;
}

fs::path manifest_path(const VerifyTarget& target) {
  return target.file.empty() ? target.result.folder / kManifest
                             : target.result.folder / (target.file + std::string(kFileManifest));
}

std::vector<std::string> file_differences(const VerifyTarget& target) {
  std::vector<std::string> found;
  const auto say = [&](const std::string& path, FileChange change) {
    found.push_back("'" + path + "' " + std::string(to_string(change)));
  };
  const fs::path manifest = manifest_path(target);
  if (!is_as_written(manifest, target.result.manifest)) {
    say(manifest.filename().string(), FileChange::changed);
  }
  if (target.file.empty()) {
    for (const FileDifference& one : differences(target.result.folder, target.result.manifest)) {
      say(one.path, one.change);
    }
    return found;
  }
  const std::vector<ManifestFile>& outputs = target.result.manifest.outputs;
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(target.result.folder / target.file, error))) {
    say(target.file, FileChange::missing);
  } else if (outputs.size() != 1 || outputs[0].path != target.file ||
             outputs[0].digest.sha256 != digest_file(target.result.folder / target.file).sha256) {
    say(target.file, FileChange::changed);
  }
  return found;
}

}  // namespace tcert::cli
