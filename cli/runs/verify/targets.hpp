#pragma once
/// \file
/// What there is to verify in a tree of results, and what nothing vouches for.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "reports/results/results.hpp"

namespace tcert::cli {

/// A folder with its manifest.json, or one file with its FILE.manifest.json.
struct VerifyTarget {
  Result result;     ///< Of a file: its folder, and the file's name.
  std::string file;  ///< Its name; empty for a folder.
};

struct VerifyTree {
  std::filesystem::path folder;
  std::vector<VerifyTarget> targets;   ///< Folders, then files, by name.
  std::vector<std::string> uncovered;  ///< Neither a target nor an input of one; a folder ends '/'.
  std::optional<SyntheticLabel> synthetic;
};

/// `path`: a folder as read_results() takes it, or a file with a manifest beside it.
/// \throws MissingResult if there is no manifest, or one that is not of this tool.
[[nodiscard]] VerifyTree verify_tree(const std::filesystem::path& path);

/// Where the target's manifest lies.
[[nodiscard]] std::filesystem::path manifest_path(const VerifyTarget& target);

/// Everything in the target that is not as its manifest lists it, in words.
[[nodiscard]] std::vector<std::string> file_differences(const VerifyTarget& target);

}  // namespace tcert::cli
