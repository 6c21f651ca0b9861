#include "cli/runs/progress.hpp"

namespace tcert::cli {

void Progress::say(std::span<const table::Diagnostic> diagnostics) {
  for (const table::Diagnostic& diagnostic : diagnostics) {
    say(table::to_string(diagnostic));
  }
}

Stage::Stage(Progress& progress, std::string_view what, std::size_t total) : progress_(progress) {
  progress_.begin(what, total);
}

Stage::~Stage() { progress_.end(); }

void Stage::reach(std::size_t done) {
  done_ = done;
  progress_.reach(done);
}

}  // namespace tcert::cli
