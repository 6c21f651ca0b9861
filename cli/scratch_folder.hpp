#pragma once
/// \file
/// A folder for work that nobody is to see.

#include <filesystem>

namespace tcert::cli {

/// Made by the constructor in the system's folder for temporary files, removed with all that it
/// holds by the destructor.
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
};

}  // namespace tcert::cli
