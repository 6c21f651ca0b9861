#pragma once
/// \file
/// Reading manifest.json again: what this tool wrote, and whether it still stands.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/manifest.hpp"

namespace tcert {

/// What a manifest says of the result that it lies beside.
struct WrittenResult {
  std::string command;
  std::vector<ManifestFile> outputs;
};

/// Empty if there is no manifest of ours at `path`.
[[nodiscard]] std::optional<WrittenResult> read_manifest(const std::filesystem::path& path);

/// The first file of `folder` that is not as `written` lists it: added, changed, or gone. Empty if
/// there is none. Reads every file. \throws std::system_error if one cannot be read.
[[nodiscard]] std::optional<std::string> first_difference(const std::filesystem::path& folder,
                                                          const WrittenResult& written);

}  // namespace tcert
