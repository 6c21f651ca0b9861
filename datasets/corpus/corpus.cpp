#include "datasets/corpus/corpus.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "datasets/corpus/figure_eight.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert {
namespace {

constexpr double kTrialLimit = 180.0;

/// The designs of the trials asked for; a block is laid out once for all of its trials.
std::vector<TrialDesign> designs_of(const CorpusOptions& options) {
  std::map<std::uint64_t, std::vector<TrialDesign>> blocks;
  const auto design = [&](std::uint64_t index) {
    const auto [block, is_new] = blocks.try_emplace(index / kTrialsPerBlock);
    if (is_new) {
      block->second = design_block(options, block->first);
    }
    return block->second[index % kTrialsPerBlock];
  };
  std::vector<TrialDesign> designs;
  if (options.subset.empty()) {
    designs.reserve(options.trials);
    for (std::uint64_t index = 0; index < options.trials; ++index) {
      designs.push_back(design(index));
    }
  }
  for (const std::uint64_t index : options.subset) {
    designs.push_back(design(index));
  }
  return designs;
}

}  // namespace

BundleInfo corpus_info(const CorpusOptions& options) {
  BundleInfo info;
  info.synthetic = true;
  info.seed = options.seed;
  info.provenance = fmt::format(
      "synthetic, seed {}: made by tcert, not logged by a robot; Table 1 and the published medians "
      "are "
      "built in, everything else is declared; {}{} trials, effect {}, streams at {}",
      options.seed,
      options.subset.empty() ? "" : fmt::format("{} of ", options.subset.size()),
      options.trials,
      options.effect,
      options.native_rates ? "83 (tactile), 50 (control) and 20 Hz (pose)" : "20 Hz");
  info.robot = corpus_robot();
  info.course = {course_start(), course_goal()};
  for (const Lighting lighting : {Lighting::dark, Lighting::indoor, Lighting::outdoor}) {
    info.lighting_tiers.emplace_back(name_of(lighting));
  }
  info.trial_limit_s = kTrialLimit;
  return info;
}

void simulate_corpus(const std::filesystem::path& folder,
                     const CorpusOptions& options,
                     const TrialProgress& progress,
                     bool replace) {
  validate(options);
  const std::vector<TrialDesign> designs = designs_of(options);
  SimulatedBundle bundle;
  bundle.info = corpus_info(options);
  bundle.extra_columns = corpus_extra_columns();
  bundle.trials = designs.size();
  bundle.simulate = [&designs](std::uint64_t i) { return simulate_trial(designs[i]); };
  write_simulated_bundle(folder, bundle, progress, replace);
}

}  // namespace tcert
