#include "cli/runs/simulate.hpp"

#include <table/csv_write.hpp>
#include <utility>

#include "cli/runs/result_folder.hpp"
#include "cli/runs/thread_limit.hpp"
#include "datasets/corpus/corpus.hpp"
#include "datasets/corpus/micro_study.hpp"

namespace tcert::cli {
namespace {

std::uint64_t seed_of(const SimulateRequest& request) {
  return static_cast<std::uint64_t>(request.seed);
}

/// Those of `trials`, counted from the first that the request asks for.
CorpusOptions corpus_of(const SimulateRequest& request, ItemRange trials) {
  const auto from = static_cast<std::uint64_t>(request.from);
  CorpusOptions corpus;
  corpus.seed = seed_of(request);
  corpus.trials = from + static_cast<std::uint64_t>(request.trials);
  corpus.effect = request.effect;
  corpus.native_rates = request.native_rates;
  if (from + trials.first > 0 || from + trials.last < corpus.trials) {
    for (std::uint64_t trial = trials.first; trial < trials.last; ++trial) {
      corpus.subset.push_back(from + trial);
    }
  }
  return corpus;
}

Manifest manifest_of(const SimulateRequest& request) {
  Manifest manifest;
  manifest.command = "simulate";
  manifest.seed = seed_of(request);
  manifest.synthetic = SyntheticLabel{seed_of(request)};
  if (request.micro_study) {
    manifest.arguments.push_back({"--micro-study"});
  }
  manifest.options = {{"micro-study", request.micro_study ? "true" : "false"}};
  if (!request.micro_study) {
    std::string effect;
    table::append_number(effect, request.effect);
    manifest.options.insert(manifest.options.end(),
                            {{"trials", std::to_string(request.trials)},
                             {"effect", effect},
                             {"native-rates", request.native_rates ? "true" : "false"}});
    if (request.from > 0) {
      manifest.options.emplace_back("from", std::to_string(request.from));
      manifest.arguments.insert(manifest.arguments.end(),
                                {{"--from"}, {std::to_string(request.from)}});
    }
    for (const auto& [name, value] : {std::pair("--trials", manifest.options[1].second),
                                      std::pair("--effect", manifest.options[2].second)}) {
      manifest.arguments.insert(manifest.arguments.end(), {{name}, {value}});
    }
    if (request.native_rates) {
      manifest.arguments.push_back({"--native-rates"});
    }
  }
  manifest.arguments.insert(manifest.arguments.end(), {{"--seed"}, {std::to_string(request.seed)}});
  return manifest;
}

}  // namespace

std::uint64_t trials_of(const SimulateRequest& request) {
  if (request.micro_study && is_given(request.given, "from")) {
    throw UsageError("--from does nothing to --micro-study");
  }
  return request.micro_study ? kGatePasses : static_cast<std::uint64_t>(request.trials);
}

void make_trials(const SimulateRequest& request,
                 ItemRange trials,
                 const std::filesystem::path& folder) {
  simulate_corpus(folder, corpus_of(request, trials));
}

OptionTable options_of(SimulateRequest& request) {
  OptionTable table(request.given);
  table
      .add("trials",
           request.trials,
           "N",
           "another number for tests of scaling; blocks of 660 are alike")
      .within(1, 1e8);
  table
      .add(
          "from", request.from, "K", "begin with trial K of the design, to make the rest elsewhere")
      .within(0, 1e9);
  table
      .add("effect",
           request.effect,
           "E",
           "how far successes and failures lie apart, 0 to 2; 0 makes a null corpus")
      .within(0, 2);
  table.add("native-rates",
            request.native_rates,
            "streams at 83, 50 and 20 Hz, as the robot logs them, instead of 20 Hz");
  table.add("micro-study",
            request.micro_study,
            "the 60 passes through gates about as wide as the body instead of the corpus");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode simulate(const SimulateRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output DIR");
  }
  const std::uint64_t trials = trials_of(request);
  const ThreadLimit limit(request.threads);
  ResultFolder result(output, "simulate");
  {
    Stage stage(progress, "simulating", trials);
    const TrialProgress advance = [&](std::uint64_t done, std::uint64_t /*total*/) {
      stage.reach(done);
    };
    if (request.micro_study) {
      simulate_micro_study(result.staging(), seed_of(request), advance, true);
    } else {
      simulate_corpus(result.staging(), corpus_of(request, {0, trials}), advance, true);
    }
  }
  result.commit(manifest_of(request));
  progress.sum_up(to_string(SyntheticLabel{seed_of(request)}) + " " + std::to_string(trials) +
                  " trials in " + output + ".");
  return exit_done;
}

bool is_there(const SimulateRequest& request) {
  return is_current(request.output.path, manifest_of(request));
}

}  // namespace tcert::cli
