#include <mutex>
#include <set>
#include <system_error>
#include <table/atomic_file.hpp>

namespace tcert::table {

namespace fs = std::filesystem;

namespace {

/// Temporaries that have no name yet. Never destroyed: an interrupt may come at any time.
struct Unfinished {
  std::mutex mutex;
  std::set<fs::path> paths;
};

Unfinished& unfinished() {
  static auto* const all = new Unfinished;
  return *all;
}

}  // namespace

void remove_when_interrupted(const fs::path& path) {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  all.paths.insert(path);
}

void forget_interrupted(const fs::path& path) noexcept {
  Unfinished& all = unfinished();
  const std::lock_guard lock(all.mutex);
  all.paths.erase(path);
}

// Whoever still writes into a folder may make a file behind us, so it is tried more than once.
void remove_unfinished() noexcept {
  Unfinished& all = unfinished();
  all.mutex.lock();
  for (const fs::path& path : all.paths) {
    std::error_code error;
    for (int attempt = 0; attempt < 20; ++attempt) {
      fs::remove_all(path, error);
      if (!error && !fs::exists(path, error)) {
        break;
      }
    }
  }
}

}  // namespace tcert::table
