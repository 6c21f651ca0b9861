#pragma once
/// \file
/// Reading manifest.json again: what this tool wrote, and whether it still stands.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/manifest.hpp"

namespace tcert {

/// What a manifest says of the result that it lies beside.
struct WrittenResult {
  std::string command;
  std::optional<std::vector<ManifestArgument>> arguments;  ///< Empty: of an older version.
  std::string tool_version;
  std::string tool_commit;
  std::optional<SyntheticLabel> synthetic;
  std::optional<std::uint64_t> seed;
  Settings options;
  Settings parameters;
  std::vector<ManifestFile> inputs;
  std::vector<ManifestFile> outputs;
};

enum class FileChange { added, changed, missing };

/// "was added", "was changed", "is missing".
[[nodiscard]] std::string_view to_string(FileChange change) noexcept;

struct FileDifference {
  std::string path;  ///< As the manifest has it: a folder ends with '/'.
  FileChange change = FileChange::changed;
};

/// Empty if there is no manifest of ours at `path`.
[[nodiscard]] std::optional<WrittenResult> read_manifest(const std::filesystem::path& path);

/// Every file of `folder` that is not as `written` lists it, by path; strange_entries() were added.
/// Reads every file.
/// \throws std::system_error if one cannot be read.
[[nodiscard]] std::vector<FileDifference> differences(const std::filesystem::path& folder,
                                                      const WrittenResult& written);

/// The first file of `folder` that is not as `written` lists it: added, changed, or gone. Empty if
/// there is none. Reads every file. \throws std::system_error if one cannot be read.
[[nodiscard]] std::optional<std::string> first_difference(const std::filesystem::path& folder,
                                                          const WrittenResult& written);

}  // namespace tcert
