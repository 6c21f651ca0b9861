#pragma once
/// \file
/// A result beside what its command makes of the same inputs: file by file, and manifest by
/// manifest.

#include <filesystem>
#include <string>
#include <vector>

#include "reports/manifest_read.hpp"

namespace tcert::cli {

/// Files that are not the same in both folders, but for manifest.json; in words, by name. Reads
/// all.
[[nodiscard]] std::vector<std::string> compare_folders(const std::filesystem::path& found,
                                                       const std::filesystem::path& again);

/// What a manifest says otherwise than that of the same command run again: parameters, options,
/// seed, origin, digests of inputs and outputs; in words.
[[nodiscard]] std::vector<std::string> compare_manifests(const WrittenResult& found,
                                                         const WrittenResult& again);

}  // namespace tcert::cli
