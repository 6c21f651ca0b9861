#pragma once
/// \file
/// Results kept on disk under the digest of what they were made from.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace tcert {

/// A folder of entries. An entry is whole or not there: it is written under a name of its own and
/// renamed, and carries the digest of its key and bytes, so that one which a crash or a hand has
/// damaged or put in the place of another counts as missing. Any number of threads and processes
/// may share a folder: whoever comes second writes the same bytes. No entry is ever removed; the
/// folder may be deleted at any time.
class ResultStore {
 public:
  /// Sweeps what killed processes have left in it. \throws WriteError if the folder cannot be made.
  explicit ResultStore(std::filesystem::path folder);

  /// `key` is 64 hexadecimal digits. Empty if there is no such entry, or none that is sound.
  [[nodiscard]] std::optional<std::string> get(std::string_view key) const;

  /// Without a sync: after a power cut an entry may be gone, never wrong. \throws WriteError.
  void put(std::string_view key, std::string_view bytes) const;

  [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_; }

 private:
  [[nodiscard]] std::filesystem::path path_of(std::string_view key) const;

  std::filesystem::path folder_;
};

}  // namespace tcert
