#pragma once
/// \file
/// What may be wrong with a manifest and the folder that it vouches for.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "reports/manifest_read.hpp"

namespace tcert {

/// to_json() as another build would write it.
[[nodiscard]] std::string to_json(const Manifest& manifest,
                                  std::string_view version,
                                  std::string_view commit);

/// Why read_manifest() finds none: "'PATH' is not a manifest of this tool", and the reason where it
/// is known.
[[nodiscard]] std::string why_no_manifest(const std::filesystem::path& path);

/// True if the file holds what this tool writes for `written`, byte for byte: nothing behind it, no
/// key that nobody reads. True for a manifest of an older version, which cannot be told.
[[nodiscard]] bool is_as_written(const std::filesystem::path& path, const WrittenResult& written);

/// What lies in `folder`, however deep, and is neither a file nor a folder: links, pipes, sockets,
/// devices. By path. None is ever part of a result; for differences() they were added.
[[nodiscard]] std::vector<std::string> strange_entries(const std::filesystem::path& folder);

}  // namespace tcert
