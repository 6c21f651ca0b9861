#pragma once
/// \file
/// Whether anybody has touched a folder since it was looked at last.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace tcert::cli {

/// What the file system says of one entry. Of a folder only that it is there: its times change with
/// what is in it, and with its own name.
struct EntryState {
  std::string path;  ///< Relative to the folder.
  std::uint64_t inode = 0;
  std::uint32_t mode = 0;
  std::int64_t bytes = 0;
  std::int64_t modified_ns = 0;
  std::int64_t changed_ns = 0;
  friend bool operator==(const EntryState&, const EntryState&) = default;
};

/// By path.
using FolderState = std::vector<EntryState>;

/// Everything below `folder`; nothing if it is no folder. Links are not followed. Reads no file:
/// about a microsecond an entry.
[[nodiscard]] FolderState state_of(const std::filesystem::path& folder);

}  // namespace tcert::cli
