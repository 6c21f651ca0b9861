#include "cli/runs/reproduce.hpp"

#include <algorithm>
#include <filesystem>
#include <table/csv_write.hpp>
#include <utility>
#include <vector>

#include "cli/runs/certify.hpp"
#include "cli/runs/experiment/cells.hpp"
#include "cli/runs/gate.hpp"
#include "cli/runs/hypotheses.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/replay.hpp"
#include "cli/runs/reproduce_driven.hpp"
#include "cli/runs/reproduce_page.hpp"
#include "cli/runs/reproduce_steps.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/simulate.hpp"
#include "datasets/corpus/tentacles.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

/// The corpus in its folder, made unless it is there.
std::string corpus_in(const char* part,
                      bool micro_study,
                      const ReproduceRequest& request,
                      Progress& progress) {
  SimulateRequest corpus;
  corpus.micro_study = micro_study;
  corpus.effect = request.effect;
  corpus.seed = request.seed;
  corpus.threads = request.threads;
  corpus.output.path = (fs::path(request.output.path) / part).string();
  if (!is_there(corpus)) {
    OnlyWords words(progress);
    static_cast<void>(simulate(corpus, words));
  }
  return corpus.output.path;
}

/// True if `inner` is `outer` or lies in it.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path in = fs::weakly_canonical(inner);
  const fs::path out = fs::weakly_canonical(outer);
  return std::mismatch(out.begin(), out.end(), in.begin(), in.end()).first == out.end();
}

/// What an earlier run left and this one does not make, and the page, which is made last: it would
/// be of other tables. Nothing is removed before all of it may be. \throws WriteError if any of it
/// was edited.
void remove_stale(const ReproduceRequest& request) {
  const fs::path output = request.output.path;
  std::vector<std::pair<fs::path, const char*>> folders;
  if (!request.sensitivity) {
    folders.emplace_back(output / "sensitivity", "sweep");
  }
  if (!request.bundle.empty()) {
    folders.emplace_back(output / "gate", "gate");
    for (const char* const part : {"gates", "corpus"}) {
      if (!lies_in(request.bundle, output / part)) {
        folders.emplace_back(output / part, "simulate");
      }
    }
  }
  if (!drives(request)) {
    for (const auto& [folder, command] : driven_parts(output)) {
      if (request.bundle.empty() || !lies_in(request.bundle, folder)) {
        folders.emplace_back(folder, command);
      }
    }
  }
  require_own_file(output / "report.html");
  require_own_file(output / "driven" / "report.html");
  for (const auto& [folder, command] : folders) {
    require_own_folder(folder, command);
  }
  for (const auto& [folder, command] : folders) {
    remove_own_folder(folder, command);
  }
  remove_own_file(output / "report.html");
  remove_own_file(output / "driven" / "report.html");
  std::error_code not_empty;
  fs::remove(output / "driven", not_empty);  // only if nothing is left in it
}

/// To be asked before anything is removed. \throws what opening the bundle does; UsageError for
/// parameters, or if a part would replace the bundle.
void require_readable(const ReproduceRequest& request, Progress& progress) {
  if (request.bundle.empty()) {
    BundleInfo corpus;
    corpus.robot = corpus_robot();
    static_cast<void>(effective_robot(corpus, effective_parameters({}, request.logs.parameters)));
  } else {
    const OpenedBundle opened =
        open_for(request.bundle, request.logs, progress, SayDiagnostics::no);
    static_cast<void>(effective_robot(opened.bundle.info, opened.parameters));
    for (const char* part : {"certificates", "replays", "ablation", "sensitivity"}) {
      require_apart(request.bundle, fs::path(request.output.path) / part);
    }
  }
}

}  // namespace

std::string landmark_of(const OpenedBundle& opened) {
  const double time_s = opened.parameters.early_window.time_s;
  std::string text;
  if (time_s != study::ParameterSet().early_window.time_s) {
    table::append_number(text, time_s);
  }
  return text;
}

OptionTable options_of(ReproduceRequest& request) {
  OptionTable table(request.given);
  table.argument({"BUNDLE", &request.bundle, false, OptionRole::input});
  table
      .add("effect",
           request.effect,
           "E",
           "of the corpus, as for 'tcert simulate'; 0 makes a null corpus")
      .within(0, 2);
  table.add("no-series", request.no_series, "leave certificates/series out, to save space");
  table.add("sensitivity",
            request.sensitivity,
            "also run under every choice that the paper leaves open, one at a time");
  table.add("no-driven",
            request.no_driven,
            "leave out the trials that policies drive in closed loop, which take most of the time");
  add_common(table, request);
  return table;
}

ExitCode reproduce(const ReproduceRequest& request, Progress& progress) {
  const fs::path output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output DIR");
  }
  require_readable(request, progress);
  // Then at once, for it finishes a page whose manifest was written and lacks its name alone.
  remove_stale(request);
  table::sweep_leftovers_in(output);
  const bool own_corpus = request.bundle.empty();
  const std::string bundle =
      own_corpus ? corpus_in("corpus", false, request, progress) : request.bundle;

  Steps steps(request, progress);
  auto certified = steps.of_logs<CertifyRequest>("certificates", bundle);
  certified.no_series = request.no_series;
  steps.require(certify, certified);
  const std::string landmark =
      landmark_of(open_for(bundle, request.logs, progress, SayDiagnostics::no));
  for (const char* const hypothesis : {"h1", "h2"}) {
    auto tested = steps.of<HypothesesRequest>(hypothesis);
    tested.hypothesis = hypothesis;
    tested.features = (steps.at("certificates") / "features.csv").string();
    tested.landmark = landmark;
    steps.attempt(hypothesis, "hypotheses", hypotheses, tested);
  }
  steps.require(replay, steps.of_logs<ReplayRequest>("replays", bundle));
  auto gated = steps.of<HypothesesRequest>("h3");
  gated.hypothesis = "h3";
  gated.replays = (steps.at("replays") / "replay.csv").string();
  steps.attempt("h3", "hypotheses", hypotheses, gated);
  steps.attempt("ablation", "ablate", ablate, steps.of_logs<AblateRequest>("ablation", bundle));
  if (request.sensitivity) {
    auto sensitivity = steps.of_logs<SweepRequest>("sensitivity", bundle);
    sensitivity.sensitivity = true;
    steps.attempt("sensitivity", "sweep", sweep, sensitivity);
  }
  if (own_corpus) {
    auto passes = steps.of<GateRequest>("gate");
    passes.bundle = corpus_in("gates", true, request, progress);
    steps.attempt("gate", "gate", gate, passes);
  }
  ExitCode code = steps.code();
  if (drives(request)) {
    try {
      code = std::max(code, driven_study(request, progress));
    } catch (const UsageError& error) {
      progress.say(std::string("driven is left out: ") + error.what());
      for (const auto& [folder, command] : driven_parts(output)) {
        remove_own_folder(folder, command);
      }
      remove_own_file(output / "driven" / "report.html");
    }
  }
  progress.show(pages_of(request, progress));
  progress.sum_up("Bundle:  " + bundle + "\nResults: " + output.string());
  write_page(request, progress);
  return code;
}

}  // namespace tcert::cli
