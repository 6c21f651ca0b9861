#include "cli/runs/bundle_digest.hpp"

#include <filesystem>
#include <string>
#include <system_error>

#include "datasets/bundle_files.hpp"

namespace tcert::cli {

FileDigest log_digest(const Bundle& bundle, const TrialRow& row) {
  const auto folder = bundle.path / "logs" / row.trial_id;
  std::error_code error;
  if (!std::filesystem::is_directory(folder, error)) {
    return {};
  }
  try {
    return digest_folder(folder);
  } catch (const std::system_error&) {
    return {};
  }
}

std::vector<ManifestFile> bundle_inputs(const Bundle& bundle, const FileDigest& logs) {
  const std::string name = name_of(bundle.path);
  if (!std::filesystem::is_directory(bundle.path)) {
    return {{name, digest_file(bundle.path)}};
  }
  std::vector<ManifestFile> inputs;
  for (const char* part : {"bundle.json", "trials.csv"}) {
    if (const auto found = BundleFiles(bundle.path).find(part)) {
      inputs.push_back({*found, digest_file(bundle.path / *found)});
    }
  }
  inputs.push_back({"logs/", logs});
  return inputs;
}

}  // namespace tcert::cli
