#include <table/atomic_file.hpp>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <system_error>
#include <table/temporary_name.hpp>
#include <table/write_steps.hpp>
#include <utility>

namespace tcert::table {

namespace fs = std::filesystem;

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  require_output_place(path_);
  std::error_code ignored;
  if (fs::is_directory(path_, ignored)) {
    fail_to_write("cannot write", path_, EISDIR);
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
    fail_to_write("cannot write", path_, errno);
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
      fail_to_write("cannot write", path_, errno);
    }
  }
}

void AtomicFile::sync() {
  if (::fsync(descriptor_) != 0) {
    fail_to_write("cannot sync", path_, errno);
  }
}

void AtomicFile::keep_when_interrupted() noexcept { forget_interrupted(temporary_); }

void AtomicFile::close() {
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail_to_write("cannot write", path_, errno);
  }
}

// A link, unlike a rename, fails where the name is taken, on network file systems too; those
// without links may know how to rename without replacing.
bool AtomicFile::commit_new() {
  sync();
  close();
  bool linked = ::link(temporary_.c_str(), path_.c_str()) == 0;
  if (!linked && errno != EEXIST) {
    linked =
        ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE) == 0;
  }
  // Who took the name may have removed what we wrote.
  std::error_code ignored;
  if (!linked && errno != EEXIST && !(errno == ENOENT && fs::exists(path_, ignored))) {
    fail_to_write("cannot link to", path_, errno);
  }
  if (linked) {
    sync_folder(folder_of(path_));
  }
  return linked;  // The destructor removes the other name.
}

void AtomicFile::commit(Durable durable) {
  if (durable == Durable::yes) {
    sync();
  }
  close();
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    fail_to_write("cannot rename to", path_, errno);
  }
  forget_interrupted(temporary_);
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

}  // namespace tcert::table
