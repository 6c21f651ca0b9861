#pragma once
/// \file
/// A fresh folder per test, removed with everything in it.

#include <filesystem>
#include <string>
#include <string_view>

namespace tcert::test_support {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

  /// Writes `text` to `name` in the folder, parents included; returns its path.
  std::filesystem::path write(std::string_view name, std::string_view text) const;

 private:
  std::filesystem::path path_;
};

/// All bytes of a file; empty if it is not there.
[[nodiscard]] std::string read_text(const std::filesystem::path& path);

/// The folder of real data: TCERT_SHARED_DATA, else ../shared/data beside the project. May not
/// exist.
[[nodiscard]] std::filesystem::path shared_data();

}  // namespace tcert::test_support
