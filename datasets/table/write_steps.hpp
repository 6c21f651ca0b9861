#pragma once
/// \file
/// Steps of writing files and folders, each of which fails with a WriteError. Internal to
/// atomic_file.cpp.

#include <filesystem>
#include <vector>

namespace tcert::table {

/// "cannot rename to 'PATH': " and what `error`, an errno, means. \throws WriteError.
[[noreturn]] void fail_to_write(const char* action, const std::filesystem::path& path, int error);

/// "." of a bare name.
[[nodiscard]] std::filesystem::path folder_of(const std::filesystem::path& path);
[[nodiscard]] std::filesystem::path without_trailing_slash(const std::filesystem::path& path);

/// The folders that had to be made for it, the deepest first. \throws WriteError.
std::vector<std::filesystem::path> create_folders(const std::filesystem::path& folder);
void sync_folder(const std::filesystem::path& folder);
void sync_file_system_of(const std::filesystem::path& folder);

}  // namespace tcert::table
