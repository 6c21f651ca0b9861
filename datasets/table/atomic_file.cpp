#include <table/atomic_file.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <set>
#include <system_error>
#include <table/temporary_name.hpp>
#include <utility>

namespace tcert::table {

namespace {

namespace fs = std::filesystem;

/// Temporaries that have no name yet. Never destroyed: an interrupt may come at any time.
struct Unfinished {
  std::mutex mutex;
  std::set<fs::path> paths;
};

Unfinished& unfinished() {
  static auto* const all = new Unfinished;
  return *all;
}

[[noreturn]] void fail(const char* action, const fs::path& path, int error) {
  throw WriteError(std::string(action) + " '" + path.string() +
                   "': " + std::generic_category().message(error));
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

void create_folders(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    fail("cannot create the folder", folder, error.value());
  }
}

void sync_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    fail("cannot open the folder", folder, errno);
  }
  const int result = ::fsync(descriptor);
  const int error = errno;
  ::close(descriptor);
  if (result != 0 && error != EINVAL) {  // EINVAL: the file system cannot sync a folder
    fail("cannot sync the folder", folder, error);
  }
}

void sync_file_system_of(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    fail("cannot open the folder", folder, errno);
  }
  const int result = ::syncfs(descriptor);
  const int error = errno;
  ::close(descriptor);
  if (result != 0) {
    fail("cannot sync", folder, error);
  }
}

/// Holds a temporary as that of a living process; -1 if the file system knows no locks.
int hold(const fs::path& temporary) noexcept {
  const int descriptor = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::flock(descriptor, LOCK_SH | LOCK_NB);
  }
  return descriptor;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw WriteError("cannot write '" + path.string() + "': " + reason);
}

/// Puts `fresh` in the place of `old` in one step; afterwards `fresh` names the old folder.
bool exchange(const fs::path& fresh, const fs::path& old) noexcept {
  return ::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  require_output_place(path_);
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) {
    fail("cannot write", path_, EISDIR);
  }
  create_folders(folder_of(path_));
  do {
    temporary_ = temporary_name(path_, Leftover::swept);
    remove_when_interrupted(temporary_);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
      const int error = errno;
      forget_interrupted(temporary_);
      errno = error;
    }
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) {
    fail("cannot write", path_, errno);
  }
  ::flock(descriptor_, LOCK_SH | LOCK_NB);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
    forget_interrupted(temporary_);
  }
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written >= 0) {
      bytes.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      fail("cannot write", path_, errno);
    }
  }
}

void AtomicFile::sync() {
  if (::fsync(descriptor_) != 0) {
    fail("cannot sync", path_, errno);
  }
}

void AtomicFile::keep_when_interrupted() noexcept { forget_interrupted(temporary_); }

void AtomicFile::commit(Durable durable) {
  if (durable == Durable::yes) {
    sync();
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail("cannot write", path_, errno);
  }
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    fail("cannot rename to", path_, errno);
  }
  forget_interrupted(temporary_);
  temporary_.clear();
  if (durable == Durable::yes) {
    sync_folder(folder_of(path_));
  }
}

void require_output_place(const fs::path& path) {
  if (path.empty()) {
    return;
  }
  const fs::path place = without_trailing_slash(path);
  struct stat status {};
  if (::lstat(place.c_str(), &status) == 0) {
    if (S_ISLNK(status.st_mode)) {
      refuse(place, "it is a link; name what it leads to, or remove it");
    }
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
      refuse(place, "it is a pipe, a socket or a device; name a file or a folder");
    }
  } else if (errno == ENAMETOOLONG) {
    fail("cannot write", place, errno);
  }
  fs::path folder = folder_of(place);
  while (::stat(folder.c_str(), &status) != 0) {
    if (errno != ENOENT || folder == folder_of(folder)) {
      fail("cannot write into the folder", folder, errno);
    }
    folder = folder_of(without_trailing_slash(folder));
  }
  if (!S_ISDIR(status.st_mode)) {
    fail("cannot write into", folder, ENOTDIR);
  }
  if (::faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    fail("cannot write into the folder", folder, errno);
  }
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

AtomicFolder::AtomicFolder(const fs::path& path, bool replace, Leftover leftover)
    : path_(without_trailing_slash(path)), replace_(replace) {
  require_output_place(path_);
  sweep_leftovers(path_);
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    fail("cannot write the folder", path_, ENOTDIR);
  }
  if (fs::exists(status) && !replace_ && !fs::is_empty(path_, error)) {
    throw WriteError("cannot replace the folder '" + path_.string() +
                     "': it is not empty; name another folder or remove this one");
  }
  create_folders(folder_of(path_));
  bool created = false;
  while (!created) {
    staging_ = temporary_name(path_, leftover);
    remove_when_interrupted(staging_);
    created = fs::create_directory(staging_, error);
    if (!created) {
      forget_interrupted(staging_);
    }
    if (error) {
      fail("cannot create the folder", path_, error.value());
    }
  }
  lock_ = hold(staging_);
}

AtomicFolder::~AtomicFolder() {
  if (lock_ >= 0) {
    ::close(lock_);  // Where descriptors are short, removing needs it.
  }
  if (!staging_.empty()) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    forget_interrupted(staging_);
  }
}

void AtomicFolder::abandon() noexcept {
  forget_interrupted(staging_);
  staging_.clear();
}

void AtomicFolder::commit(const std::function<void(const fs::path&)>& still_ours) {
  sync_file_system_of(staging_);
  // rename(2) replaces an empty folder by itself; a full one is exchanged and then removed.
  if (::rename(staging_.c_str(), path_.c_str()) == 0) {
    forget_interrupted(staging_);
    staging_.clear();
  } else if (const int error = errno; !replace_ || !exchange(staging_, path_)) {
    fail("cannot rename to", path_, error);
  } else if (still_ours) {
    // Until it is known to be ours an interrupt must not remove it.
    forget_interrupted(staging_);
    try {
      still_ours(staging_);
    } catch (const WriteError&) {
      if (!exchange(staging_, path_)) {
        // Under a name that nothing sweeps.
        const fs::path kept = temporary_name(path_, Leftover::kept);
        const std::string old =
            (::rename(staging_.c_str(), kept.c_str()) == 0 ? kept : staging_).string();
        staging_.clear();
        throw WriteError("cannot give '" + path_.string() +
                         "' its old contents back, which were changed while they were made again; "
                         "they lie in '" +
                         old + "'");
      }
      remove_when_interrupted(staging_);
      throw;
    }
    remove_when_interrupted(staging_);
  }
  sync_folder(folder_of(path_));
  if (!staging_.empty()) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    forget_interrupted(staging_);
    staging_.clear();
  }
}

void remove_when_interrupted(const fs::path& path) {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  all.paths.insert(path);
}

void forget_interrupted(const fs::path& path) noexcept {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  all.paths.erase(path);
}

// Whoever still writes into a folder may make a file behind us, so it is tried more than once.
void remove_unfinished() noexcept {
  Unfinished& all = unfinished();
  all.mutex.lock();
  for (const fs::path& path : all.paths) {
    std::error_code error;
    for (int attempt = 0; attempt < 20; ++attempt) {
      fs::remove_all(path, error);
      if (!error && !fs::exists(path, error)) {
        break;
      }
    }
  }
}

}  // namespace tcert::table
