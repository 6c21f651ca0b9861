#include <table/write_steps.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <table/atomic_file.hpp>

namespace tcert::table {

namespace fs = std::filesystem;

namespace {

int opened(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    fail_to_write("cannot open the folder", folder, errno);
  }
  return descriptor;
}

}  // namespace

void fail_to_write(const char* action, const fs::path& path, int error) {
  throw WriteError(std::string(action) + " '" + path.string() +
                   "': " + std::generic_category().message(error));
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

std::vector<fs::path> create_folders(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> created;
  for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) {
    created.push_back(at);
  }
  fs::create_directories(folder, error);
  if (error) {
    fail_to_write("cannot create the folder", folder, error.value());
  }
  return created;
}

void sync_folder(const fs::path& folder) {
  const int descriptor = opened(folder);
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  if (result != 0 && error != EINVAL) {  // EINVAL: the file system cannot sync a folder
    fail_to_write("cannot sync the folder", folder, error);
  }
}

void sync_file_system_of(const fs::path& folder) {
  const int descriptor = opened(folder);
  const int result = ::syncfs(descriptor);
  const int error = errno;
  ::close(descriptor);
  if (result != 0) {
    fail_to_write("cannot sync", folder, error);
  }
}

}  // namespace tcert::table
