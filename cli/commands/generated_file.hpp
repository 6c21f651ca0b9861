#pragma once
/// \file
/// Files that the tool makes of itself, and may make again.

#include <filesystem>
#include <string_view>

namespace tcert::cli {

/// Writes a file, with the folders that it lies in. One that is there already is replaced only if
/// `mark`, which is in `text`, is in its beginning. \throws WriteError.
void write_generated(const std::filesystem::path& path,
                     std::string_view text,
                     std::string_view mark);

}  // namespace tcert::cli
