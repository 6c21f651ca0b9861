#include <algorithm>
#include <span>
#include <utility>

#include "cli/runs/study/studies.hpp"
#include "reports/study/soundness_report.hpp"

namespace tcert::cli {
namespace {

/// Worlds between two looks at how far it is.
constexpr std::size_t kBatch = 1000;

std::vector<study::WorldOutcome> outcomes(const SoundnessWorlds& kind,
                                          study::SoundnessOptions options,
                                          Progress& progress) {
  const std::size_t worlds = options.worlds;
  std::vector<study::WorldOutcome> all;
  Stage stage(progress, kind.name + " worlds", worlds);
  while (all.size() < worlds) {
    options.first = all.size();
    options.worlds = std::min(kBatch, worlds - all.size());
    const auto batch = study::study_soundness(kind.methods, options);
    all.insert(all.end(), batch.begin(), batch.end());
    stage.reach(all.size());
  }
  return all;
}

}  // namespace

FitReport soundness_study(const StudyRequest& request, Progress& progress) {
  study::SoundnessOptions options;
  options.seed = static_cast<std::uint64_t>(request.seed);
  SoundnessRuns runs;
  runs.seed = options.seed;
  const auto run = [&](const char* name,
                       std::int64_t worlds,
                       WorldFamily (*family)(std::uint64_t),
                       std::span<const WorldFamily> families,
                       std::vector<study::SoundnessMethod> methods) {
    SoundnessWorlds kind{name, {families.begin(), families.end()}, std::move(methods), {}};
    if (request.witness) {
      kind.methods = study::witness_methods();
    }
    options.worlds = static_cast<std::size_t>(worlds);
    options.family = family;
    kind.worlds = outcomes(kind, options, progress);
    runs.kinds.push_back(std::move(kind));
  };
  run("mixed", request.worlds, mixed_family, kMixedFamilies, study::mixed_methods());
  run("hard", request.hard, hard_family, kHardFamilies, study::mixed_methods());
  run("u_turn", request.u_turns, u_turn_family, {}, study::u_turn_methods());
  if (request.driven > 0) {
    options.driven = true;
    run("driven", request.driven, mixed_family, {}, study::mixed_methods());
  }
  return soundness_report(runs);
}

}  // namespace tcert::cli
