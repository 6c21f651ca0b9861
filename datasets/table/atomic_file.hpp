#pragma once
/// \file
/// Files that are either whole or not there: write beside, fsync, rename.

#include <filesystem>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::table {

/// A file or folder could not be written. Exit code 73.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Whether a committed file outlives a power cut, or may be lost or cut short in it.
enum class Durable { yes, no };

/// What a folder or file is written into before it has its name: hidden, beside it, and held by a
/// lock (flock) as long as its process lives. It is called `.NAME.PID-N.tmp`, or for what people
/// shall find after a crash `.NAME.PID-N.kept.tmp`.
enum class Leftover {
  swept,  ///< Removed by sweep_leftovers() once the process is dead.
  kept,   ///< Never removed by us: it is all that there is of a run of hours.
};

/// \throws WriteError if nothing can appear at `path`: it is a link (whose target somebody else may
/// use), a pipe, a socket or a device, or the folder that it is to lie in is none or not writable.
/// For use before any work is done. An empty path is not looked at.
void require_output_place(const std::filesystem::path& path);

/// Removes what processes that are dead have left half written beside `path`, of `path`.
void sweep_leftovers(const std::filesystem::path& path) noexcept;

/// The same of everything that was to appear in `folder` itself.
void sweep_leftovers_in(const std::filesystem::path& folder) noexcept;

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

  /// What was written outlives a power cut, under the name of the temporary. \throws WriteError.
  void sync();

  /// An interrupt no longer removes what is written: the next run finds it.
  void keep_when_interrupted() noexcept;

  /// sync() unless told otherwise, and rename. \throws WriteError.
  void commit(Durable durable = Durable::yes);

  /// The same, but takes no name that is taken, whoever takes it at the same time, on whichever
  /// machine: false if it is. \throws WriteError.
  [[nodiscard]] bool commit_new();

 private:
  void close();

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
  /// Sweeps what dead processes left of the same name. \throws WriteError if the name is taken or
  /// the parent cannot be written.
  explicit AtomicFolder(const std::filesystem::path& path,
                        bool replace = false,
                        Leftover leftover = Leftover::swept);
  ~AtomicFolder();
  AtomicFolder(const AtomicFolder&) = delete;
  AtomicFolder& operator=(const AtomicFolder&) = delete;

  /// Where to write until commit.
  [[nodiscard]] const std::filesystem::path& staging() const noexcept { return staging_; }

  /// `still_ours` is asked of the old folder, which lies at the path that it is given, when the new
  /// one has its name: if it says no, the old one gets its name back. Nothing else can be at work
  /// in it by that name any more, so that nothing that somebody did meanwhile is lost.
  /// \throws WriteError; with the words of `still_ours` if it throws one.
  void commit(const std::function<void(const std::filesystem::path&)>& still_ours = {});

  /// Leaves the hidden folder as it is for people to look into, and forgets it.
  void abandon() noexcept;

 private:
  std::filesystem::path path_;
  std::filesystem::path staging_;
  std::vector<std::filesystem::path> created_;  // above it, the deepest first
  int lock_ = -1;
  bool replace_ = false;
};

/// A file or folder that is removed by remove_unfinished(), until it is forgotten.
void remove_when_interrupted(const std::filesystem::path& path);
void forget_interrupted(const std::filesystem::path& path) noexcept;

/// Removes the temporaries of all files and folders that are not committed, for a process that is
/// about to end: whoever would create or commit one afterwards waits for ever.
void remove_unfinished() noexcept;

}  // namespace tcert::table
