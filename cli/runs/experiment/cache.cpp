#include "cli/runs/experiment/cache.hpp"

#include <cstdlib>
#include <table/atomic_file.hpp>

#include "cli/runs/progress.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

void say_without(const std::string& reason, Progress& progress) {
  progress.say("warning: nothing is kept for the next run: " + reason +
               "; the results are the same");
}

}  // namespace

Cache::Cache(const fs::path& folder, Progress& progress) : progress_(progress) {
  try {
    store_.emplace(folder);
  } catch (const table::WriteError& error) {
    say_without(error.what(), progress_);
  }
}

std::optional<fs::path> Cache::folder_of_user(Progress& progress) {
  const auto variable = [](const char* name) -> fs::path {
    const char* const value = std::getenv(name);
    return value != nullptr ? value : "";
  };
  if (const auto cache = variable("XDG_CACHE_HOME"); cache.is_absolute()) {
    return cache / "tcert";
  }
  if (const auto home = variable("HOME"); home.is_absolute()) {
    return home / ".cache" / "tcert";
  }
  say_without("neither XDG_CACHE_HOME nor HOME names a folder, nor does --cache", progress);
  return std::nullopt;
}

std::optional<std::string> Cache::get(std::string_view key) const {
  return store_ ? store_->get(key) : std::nullopt;
}

void Cache::put(std::string_view key, std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  if (!store_ || !may_write_) {
    return;
  }
  try {
    store_->put(key, bytes);
  } catch (const table::WriteError& error) {
    may_write_ = false;
    say_without(error.what(), progress_);
  }
}

}  // namespace tcert::cli
