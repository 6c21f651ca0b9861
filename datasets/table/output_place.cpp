#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <table/atomic_file.hpp>
#include <table/write_steps.hpp>

namespace tcert::table {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_place(const fs::path& path, const std::string& reason) {
  throw WriteError("cannot write '" + path.string() + "': " + reason);
}

}  // namespace

void require_output_place(const fs::path& path) {
  if (path.empty()) {
    return;
  }
  const fs::path place = without_trailing_slash(path);
  struct stat status {};
  if (::lstat(place.c_str(), &status) == 0) {
    if (S_ISLNK(status.st_mode)) {
      refuse_place(place, "it is a link; name what it leads to, or remove it");
    }
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
      refuse_place(place, "it is a pipe, a socket or a device; name a file or a folder");
    }
  } else if (errno == ENAMETOOLONG) {
    fail_to_write("cannot write", place, errno);
  }
  fs::path folder = folder_of(place);
  while (::stat(folder.c_str(), &status) != 0) {
    if (errno != ENOENT || folder == folder_of(folder)) {
      fail_to_write("cannot write into the folder", folder, errno);
    }
    folder = folder_of(without_trailing_slash(folder));
  }
  if (!S_ISDIR(status.st_mode)) {
    fail_to_write("cannot write into", folder, ENOTDIR);
  }
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    fail_to_write("cannot write into the folder", folder, errno);
  }
}

}  // namespace tcert::table
