#pragma once
/// \file
/// A folder for work that nobody is to see.

#include <filesystem>

namespace tcert::cli {

/// Made by the constructor in the system's folder for temporary files, for our eyes only; removed
/// with all that it holds by the destructor, by an interrupt, or if the process is killed by the
/// next one that makes one.
class ScratchFolder {
 public:
  /// \throws WriteError.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace tcert::cli
