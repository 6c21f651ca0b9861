#include "cli/simulated.hpp"

#include <tbb/global_control.h>

#include <optional>
#include <table/csv_write.hpp>
#include <utility>

#include "cli/progress.hpp"
#include "cli/result_folder.hpp"
#include "datasets/corpus/micro_study.hpp"

namespace tcert::cli {
namespace {

std::uint64_t trials_of(const SimulatedCorpus& corpus) {
  return corpus.micro_study ? kGatePasses : corpus.options.trials;
}

Manifest manifest_of(const SimulatedCorpus& corpus) {
  Manifest manifest;
  manifest.command = "simulate";
  manifest.seed = corpus.options.seed;
  manifest.synthetic = SyntheticLabel{corpus.options.seed};
  if (corpus.micro_study) {
    manifest.arguments.push_back({"--micro-study"});
  }
  manifest.options = {{"micro-study", corpus.micro_study ? "true" : "false"}};
  if (!corpus.micro_study) {
    std::string effect;
    table::append_number(effect, corpus.options.effect);
    manifest.options.insert(manifest.options.end(),
                            {{"trials", std::to_string(corpus.options.trials)},
                             {"effect", effect},
                             {"native-rates", corpus.options.native_rates ? "true" : "false"}});
    for (const auto& [name, value] : {std::pair("--trials", manifest.options[1].second),
                                      std::pair("--effect", manifest.options[2].second)}) {
      manifest.arguments.insert(manifest.arguments.end(), {{name}, {value}});
    }
    if (corpus.options.native_rates) {
      manifest.arguments.push_back({"--native-rates"});
    }
  }
  manifest.arguments.insert(manifest.arguments.end(),
                            {{"--seed"}, {std::to_string(corpus.options.seed)}});
  return manifest;
}

}  // namespace

std::uint64_t write_corpus(const SimulatedCorpus& corpus,
                           const std::filesystem::path& folder,
                           const CommonOptions& common) {
  std::optional<tbb::global_control> limit;
  if (common.threads > 0) {
    limit.emplace(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(common.threads));
  }
  ResultFolder result(folder, "simulate");
  {
    Progress progress("simulating", trials_of(corpus), common.quiet);
    const TrialProgress advance = [&](std::uint64_t done, std::uint64_t /*total*/) {
      progress.reach(done);
    };
    if (corpus.micro_study) {
      simulate_micro_study(result.staging(), corpus.options.seed, advance, true);
    } else {
      simulate_corpus(result.staging(), corpus.options, advance, true);
    }
  }
  result.commit(manifest_of(corpus));
  return trials_of(corpus);
}

bool is_there(const SimulatedCorpus& corpus, const std::filesystem::path& folder) {
  return is_current(folder, manifest_of(corpus));
}

}  // namespace tcert::cli
