#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <table/atomic_file.hpp>
#include <table/temporary_name.hpp>
#include <table/write_steps.hpp>

namespace tcert::table {

namespace fs = std::filesystem;

namespace {

/// Holds a temporary as that of a living process; -1 if the file system knows no locks.
int hold(const fs::path& temporary) noexcept {
  const int descriptor = ::open(temporary.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::flock(descriptor, LOCK_SH | LOCK_NB);
  }
  return descriptor;
}

/// Puts `fresh` in the place of `old` in one step; afterwards `fresh` names the old folder.
bool exchange(const fs::path& fresh, const fs::path& old) noexcept {
  return ::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, old.c_str(), RENAME_EXCHANGE) == 0;
}

}  // namespace

AtomicFolder::AtomicFolder(const fs::path& path, bool replace, Leftover leftover)
    : path_(without_trailing_slash(path)), replace_(replace) {
  require_output_place(path_);
  sweep_leftovers(path_);
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  if (fs::exists(status) && !fs::is_directory(status)) {
    fail_to_write("cannot write the folder", path_, ENOTDIR);
  }
  if (fs::exists(status) && !replace_ && !fs::is_empty(path_, error)) {
    throw WriteError("cannot replace the folder '" + path_.string() +
                     "': it is not empty; name another folder or remove this one");
  }
  created_ = create_folders(folder_of(path_));
  bool created = false;
  while (!created) {
    staging_ = temporary_name(path_, leftover);
    remove_when_interrupted(staging_);
    created = fs::create_directory(staging_, error);
    if (!created) {
      forget_interrupted(staging_);
    }
    if (error) {
      fail_to_write("cannot create the folder", path_, error.value());
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
    for (const fs::path& folder : created_) {
      ::rmdir(folder.c_str());  // Only if nobody has put anything there.
    }
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
    fail_to_write("cannot rename to", path_, error);
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

}  // namespace tcert::table
