#include "cli/runs/watched_stages.hpp"

namespace tcert::cli {

study::Watch WatchedStages::watch() {
  return {[this](const std::string& part, std::size_t steps) { begin(part, steps); },
          [this] { advance(); }};
}

void WatchedStages::end() {
  const std::lock_guard lock(mutex_);
  stage_.reset();
}

void WatchedStages::begin(const std::string& part, std::size_t steps) {
  const std::lock_guard lock(mutex_);
  stage_.reset();  // One stage at a time: the old one ends before the new one begins.
  stage_.emplace(progress_, part, steps);
}

void WatchedStages::advance() {
  const std::lock_guard lock(mutex_);
  if (stage_) {
    stage_->advance();
  }
}

}  // namespace tcert::cli
