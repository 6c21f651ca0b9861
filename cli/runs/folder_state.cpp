#include "cli/runs/folder_state.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

std::int64_t nanoseconds(const timespec& time) {
  return static_cast<std::int64_t>(time.tv_sec) * 1'000'000'000 + time.tv_nsec;
}

EntryState entry_of(const fs::path& path, std::string name) {
  EntryState entry;
  entry.path = std::move(name);
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) {
    return entry;
  }
  entry.inode = status.st_ino;
  entry.mode = status.st_mode;
  if (!S_ISDIR(status.st_mode)) {
    entry.bytes = status.st_size;
    entry.modified_ns = nanoseconds(status.st_mtim);
    entry.changed_ns = nanoseconds(status.st_ctim);
  }
  return entry;
}

}  // namespace

FolderState state_of(const fs::path& folder) {
  FolderState state;
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return state;
  }
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    state.push_back(entry_of(at->path(), at->path().lexically_relative(folder).generic_string()));
  }
  std::sort(state.begin(), state.end(), [](const EntryState& a, const EntryState& b) {
    return a.path < b.path;
  });
  return state;
}

}  // namespace tcert::cli
