#include "datasets/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <set>
#include <system_error>
#include <utility>

namespace tcert {

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

void begin(const fs::path& temporary) {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  all.paths.insert(temporary);
}

void forget(const fs::path& temporary) noexcept {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  all.paths.erase(temporary);
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

/// Hidden, beside `path`, and not used by another thread or process.
fs::path temporary_name(const fs::path& path) {
  static std::atomic<unsigned> next{0};
  std::string name(1, '.');
  name += path.filename().string();
  name += '.';
  name += std::to_string(::getpid());
  name += '-';
  name += std::to_string(next++);
  name += ".tmp";
  return folder_of(path) / name;
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

/// A pipe or a device is written to as it is: renaming over it would replace it.
bool takes_writes_directly(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::is_character_file(status) || fs::is_fifo(status) || fs::is_socket(status);
}

/// Puts `fresh` in the place of `old` in one step; afterwards `fresh` names the old folder.
bool exchange(const fs::path& fresh, const fs::path& old) noexcept {
  return ::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  if (takes_writes_directly(path_)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  } else {
    std::error_code ignored;
    if (fs::is_directory(path_, ignored)) {
      fail("cannot write", path_, EISDIR);
    }
    create_folders(folder_of(path_));
    do {
      temporary_ = temporary_name(path_);
      begin(temporary_);
      descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ < 0) {
        const int error = errno;
        forget(temporary_);
        errno = error;
      }
    } while (descriptor_ < 0 && errno == EEXIST);
  }
  if (descriptor_ < 0) {
    fail("cannot write", path_, errno);
  }
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
    forget(temporary_);
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

void AtomicFile::commit(Durable durable) {
  const bool direct = temporary_.empty();
  if (durable == Durable::yes && !direct && ::fsync(descriptor_) != 0) {
    fail("cannot sync", path_, errno);
  }
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail("cannot write", path_, errno);
  }
  if (direct) {
    return;
  }
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    fail("cannot rename to", path_, errno);
  }
  forget(temporary_);
  temporary_.clear();
  if (durable == Durable::yes) {
    sync_folder(folder_of(path_));
  }
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

AtomicFolder::AtomicFolder(const fs::path& path, bool replace)
    : path_(without_trailing_slash(path)), replace_(replace) {
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
    staging_ = temporary_name(path_);
    begin(staging_);
    created = fs::create_directory(staging_, error);
    if (!created) {
      forget(staging_);
    }
    if (error) {
      fail("cannot create the folder", path_, error.value());
    }
  }
}

AtomicFolder::~AtomicFolder() {
  if (!staging_.empty()) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    forget(staging_);
  }
}

void AtomicFolder::abandon() noexcept {
  forget(staging_);
  staging_.clear();
}

void AtomicFolder::commit() {
  sync_file_system_of(staging_);
  // rename(2) replaces an empty folder by itself; a full one is exchanged and then removed.
  if (::rename(staging_.c_str(), path_.c_str()) == 0) {
    forget(staging_);
    staging_.clear();
  } else if (const int error = errno; !replace_ || !exchange(staging_, path_)) {
    fail("cannot rename to", path_, error);
  }
  sync_folder(folder_of(path_));
  if (!staging_.empty()) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
    forget(staging_);
    staging_.clear();
  }
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

}  // namespace tcert
