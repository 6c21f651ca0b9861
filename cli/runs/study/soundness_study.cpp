#include <algorithm>

#include "cli/runs/study/studies.hpp"
#include "reports/study/soundness_report.hpp"

namespace tcert::cli {
namespace {

/// Worlds between two looks at how far it is.
constexpr std::size_t kBatch = 1000;

std::vector<study::WorldOutcome> outcomes(const std::vector<study::SoundnessMethod>& methods,
                                          study::SoundnessOptions options,
                                          Progress& progress) {
  const std::size_t worlds = options.worlds;
  std::vector<study::WorldOutcome> all;
  Stage stage(progress, options.family ? "U-turns" : "worlds", worlds);
  while (all.size() < worlds) {
    options.first = all.size();
    options.worlds = std::min(kBatch, worlds - all.size());
    const auto batch = study::study_soundness(methods, options);
    all.insert(all.end(), batch.begin(), batch.end());
    stage.reach(all.size());
  }
  return all;
}

}  // namespace

FitReport soundness_study(const StudyRequest& request, Progress& progress) {
  study::SoundnessOptions options;
  options.seed = static_cast<std::uint64_t>(request.seed);
  options.worlds = static_cast<std::size_t>(request.worlds);
  SoundnessRuns runs;
  runs.seed = options.seed;
  runs.mixed_methods = request.witness ? study::witness_methods() : study::mixed_methods();
  runs.mixed = outcomes(runs.mixed_methods, options, progress);
  options.family = WorldFamily::u_turn;
  options.worlds = static_cast<std::size_t>(request.u_turns);
  runs.turn_methods = request.witness ? study::witness_methods() : study::u_turn_methods();
  runs.turns = outcomes(runs.turn_methods, options, progress);
  return soundness_report(runs);
}

}  // namespace tcert::cli
