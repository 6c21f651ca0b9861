#pragma once
/// \file
/// Files that are either whole or not there: write beside, fsync, rename.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tcert {

/// A file or folder could not be written. Exit code 73.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether a committed file outlives a power cut, or may be lost or cut short in it.
enum class Durable { yes, no };

/// A file that appears under its name only when committed. Not copyable.
/// The temporary lies beside it, so the rename is on one file system; an uncommitted file removes
/// its temporary.
class AtomicFile {
 public:
  /// Creates missing parent folders. \throws WriteError naming the path and the reason.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// \throws WriteError, for instance when the disk is full.
  void write(std::string_view bytes);

  /// fsync unless told otherwise, and rename. \throws WriteError.
  void commit(Durable durable = Durable::yes);

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  int descriptor_ = -1;
};

/// The whole of a small file in one call. \throws WriteError.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// A folder that appears under its name only when committed: files are written into a hidden folder
/// beside it, which is synced once and renamed. Replaces an existing folder of the same name only
/// if that folder is empty or `replace` is true.
class AtomicFolder {
 public:
  /// \throws WriteError if the name is taken or the parent cannot be written.
  explicit AtomicFolder(const std::filesystem::path& path, bool replace = false);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Where to write until commit.
  [[nodiscard]] const std::filesystem::path& staging() const noexcept { return staging_; }

  /// \throws WriteError.
  void commit();

  /// Leaves the hidden folder as it is for people to look into, and forgets it.
  void abandon() noexcept;

 private:
  std::filesystem::path path_;
  std::filesystem::path staging_;
  bool replace_ = false;
};

/// Removes the temporaries of all files and folders that are not committed, for a process that is
/// about to end: whoever would create or commit one afterwards waits for ever.
void remove_unfinished() noexcept;

}  // namespace tcert
