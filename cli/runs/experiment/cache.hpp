#pragma once
/// \file
/// What a run of cells keeps for the next one: a convenience, without which the results are the
/// same.

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "cli/runs/progress.hpp"
#include "reports/result_store.hpp"

namespace tcert::cli {

/// A folder of results that may fail: what goes wrong is said once, and from then on nothing is
/// kept. Thread-safe.
class Cache {
 public:
  /// Says why if the folder cannot be made or written.
  Cache(const std::filesystem::path& folder, Progress& progress);

  /// $XDG_CACHE_HOME/tcert, or ~/.cache/tcert; says so if there is neither.
  [[nodiscard]] static std::optional<std::filesystem::path> folder_of_user(Progress& progress);

  [[nodiscard]] std::optional<std::string> get(std::string_view key) const;
  void put(std::string_view key, std::string_view bytes);

 private:
  Progress& progress_;
  std::optional<ResultStore> store_;
  std::mutex mutex_;
  bool may_write_ = true;
};

}  // namespace tcert::cli
