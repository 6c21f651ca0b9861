#pragma once
/// \file
/// A stage of progress for each part of a study that can be watched.

#include <cstddef>
#include <mutex>
#include <optional>
#include <string>

#include "analysis/study/watch.hpp"
#include "cli/runs/progress.hpp"

namespace tcert::cli {

class WatchedStages {
 public:
  explicit WatchedStages(Progress& progress) : progress_(progress) {}

  /// Begins a stage for each part, and advances it whichever thread reports. \pre this outlives it.
  [[nodiscard]] study::Watch watch();

  /// Ends the last stage, before anything is said.
  void end();

 private:
  void begin(const std::string& part, std::size_t steps);
  void advance();

  Progress& progress_;
  std::mutex mutex_;
  std::optional<Stage> stage_;
};

}  // namespace tcert::cli
