#pragma once
/// \file
/// A folder of results that appears whole, with its manifest, or not at all.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <table/atomic_file.hpp>

#include "cli/runs/folder_state.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// A file that is written piece by piece, within a folder that is not there yet.
class ResultFile {
 public:
  /// \throws WriteError.
  explicit ResultFile(std::filesystem::path path);

  void write(std::string_view bytes);  ///< \throws WriteError.
  void flush();                        ///< \throws WriteError.
  void close();                        ///< \throws WriteError.

 private:
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

class ResultFolder {
 public:
  /// Replaces a folder only if it is empty, or holds what the same command wrote and nothing else:
  /// no file added and none changed.
  /// \throws WriteError if the name is taken or cannot be written: before any work is done.
  ResultFolder(const std::filesystem::path& path, std::string command);

  [[nodiscard]] const std::filesystem::path& staging() const noexcept { return folder_.staging(); }

  /// A whole file; its folders are made. Thread-safe for different names. \throws WriteError; also
  /// for a name that does not lead into the folder, or leads through a link.
  void write(const std::filesystem::path& name, std::string_view bytes) const;

  /// Lists the files in the manifest, writes it, and gives the folder its name. What was edited in
  /// the old folder meanwhile stays: the new results are then dropped. \throws WriteError.
  void commit(Manifest manifest);

 private:
  std::filesystem::path path_;
  std::string command_;
  FolderState before_;  ///< Of the folder that is to be replaced, when it was looked through.
  table::AtomicFolder folder_;
};

/// True if `folder` holds what this manifest, made again, would list, every file with its bytes.
[[nodiscard]] bool is_current(const std::filesystem::path& folder, Manifest expected);

/// For use before any work is done. Finishes what a killed process had all but finished, and sweeps
/// what it left; an empty path is not looked at. \throws WriteError if a file of that name is there
/// which this tool did not write or which was changed since; see require_output_place.
void require_own_file(const std::filesystem::path& path);

/// \throws WriteError if there is something that ResultFolder(path, command) may not replace.
void require_own_folder(const std::filesystem::path& path, const std::string& command);

/// Removes what ResultFolder(path, command) would replace, if it is there. \throws WriteError if it
/// may not be replaced.
void remove_own_folder(const std::filesystem::path& path, const std::string& command);

/// Removes a file that write_with_manifest() wrote, and its manifest, if it is there.
/// \throws WriteError; see require_own_file.
void remove_own_file(const std::filesystem::path& path);

/// One file of results and, beside it, <file>.manifest.json. The manifest is on disk before the
/// file gets its name, so that of a process that is killed in between the next one can tell whose
/// the file is. \throws WriteError; see require_own_file.
void write_with_manifest(const std::filesystem::path& path,
                         std::string_view text,
                         Manifest manifest);

/// \throws UsageError if `output` is or holds `input`; WriteError, see require_output_place().
void require_apart(const std::filesystem::path& input, const std::filesystem::path& output);

}  // namespace tcert::cli
