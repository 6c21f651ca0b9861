#include "cli/runs/verify/find_input.hpp"

#include <algorithm>
#include <system_error>
#include <table/path_name.hpp>

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> candidates_of(const std::string& name,
                                    const VerifyTarget& target,
                                    const fs::path& results,
                                    const std::vector<std::string>& given) {
  std::vector<fs::path> candidates;
  const auto add = [&](const fs::path& place) {
    if (name_of(place) == name) {
      candidates.push_back(place);
    }
    candidates.push_back(place / name);
  };
  for (const std::string& place : given) {
    add(place);
  }
  const fs::path folder = fs::weakly_canonical(results);
  for (const fs::path& beside : {folder, folder.parent_path()}) {
    add(beside);
    if (beside == folder || target.result.name == ".") {
      std::vector<fs::path> parts;
      for (const auto& entry : fs::directory_iterator(beside)) {
        if (entry.is_directory() && !table::is_temporary_name(entry.path().filename().native())) {
          parts.push_back(entry.path() / name);
        }
      }
      std::sort(parts.begin(), parts.end());
      candidates.insert(candidates.end(), parts.begin(), parts.end());
    }
  }
  std::error_code error;
  if (const fs::path here = fs::current_path(error); !error) {
    add(here);
  }
  return candidates;
}

}  // namespace

std::optional<fs::path> find_input(const std::string& name,
                                   const VerifyTarget& target,
                                   const fs::path& results,
                                   const std::vector<std::string>& given) {
  std::vector<fs::path> candidates = candidates_of(name, target, results, given);
  std::error_code error;
  std::erase_if(candidates, [&](const fs::path& path) { return !fs::exists(path, error); });
  for (const fs::path& path : candidates) {
    for (const ManifestFile& input : target.result.manifest.inputs) {
      if (input.path == name && fs::is_regular_file(path, error) &&
          digest_file(path).sha256 == input.digest.sha256) {
        return path;
      }
    }
  }
  return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

}  // namespace tcert::cli
