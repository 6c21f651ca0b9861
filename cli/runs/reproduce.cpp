#include "cli/runs/reproduce.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <table/csv_write.hpp>
#include <utility>
#include <vector>

#include "cli/runs/certify.hpp"
#include "cli/runs/experiment/batch.hpp"
#include "cli/runs/gate.hpp"
#include "cli/runs/hypotheses.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/replay.hpp"
#include "cli/runs/report/report.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/simulate.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "reports/findings.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

/// The runs of the study, one after the other, each into its folder.
class Steps {
 public:
  Steps(const ReproduceRequest& request, Progress& progress)
      : request_(request), progress_(progress), parts_(progress), folder_(request.output.path) {}

  [[nodiscard]] fs::path at(const char* part) const { return folder_ / part; }

  /// A request for a part, told all that was told to this run.
  template <class Request>
  [[nodiscard]] Request of(const char* part) const {
    Request request;
    request.output.path = (folder_ / part / "").string();
    request.threads = request_.threads;
    if constexpr (requires { request.seed; }) {
      request.seed = request_.seed;
      request.given = {"seed"};  // Named in the manifest, whatever it is.
    }
    return request;
  }

  /// Likewise, for a run that reads the logs.
  template <class Request>
  [[nodiscard]] Request of_logs(const char* part, const std::string& bundle) const {
    auto request = of<Request>(part);
    request.bundle = bundle;
    request.logs = request_.logs;
    return request;
  }

  /// Must go well.
  template <class Request>
  void require(ExitCode (*run)(const Request&, Progress&), const Request& request) {
    const ExitCode code = run(request, parts_);
    if (code != exit_done && code != exit_rejected) {
      throw BadData("'" + request.output.path + "' could not be made");
    }
    note(code);
  }

  /// May be impossible with these data: it is left out then, and nothing of an earlier run stands
  /// for it.
  template <class Request>
  void attempt(const char* part,
               const char* command,
               ExitCode (*run)(const Request&, Progress&),
               const Request& request) {
    const auto leave_out = [&](const std::exception& error) {
      remove_own_folder(folder_ / part, command);
      progress_.say(std::string(part) + " is left out: " + error.what());
    };
    try {
      const ExitCode code = run(request, parts_);
      if (code == exit_bad_data) {
        progress_.say(std::string(part) +
                      " has no estimate, as said above; what there is stands in " +
                      (folder_ / part).string());
      } else {
        note(code);
      }
    } catch (const BadData& error) {
      leave_out(error);
    } catch (const UnfitData& error) {
      leave_out(error);
    }
  }

  [[nodiscard]] ExitCode code() const noexcept { return code_; }

 private:
  void note(ExitCode code) { code_ = std::max(code_, code); }

  const ReproduceRequest& request_;
  Progress& progress_;
  WithoutSums parts_;
  fs::path folder_;
  ExitCode code_ = exit_done;
};

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

/// Where the landmark of the features is, if not where it usually is.
std::string landmark_of(const OpenedBundle& opened) {
  const double time_s = opened.parameters.early_window.time_s;
  std::string text;
  if (time_s != study::ParameterSet().early_window.time_s) {
    table::append_number(text, time_s);
  }
  return text;
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
  require_own_file(output / "report.html");
  for (const auto& [folder, command] : folders) {
    require_own_folder(folder, command);
  }
  for (const auto& [folder, command] : folders) {
    remove_own_folder(folder, command);
  }
  remove_own_file(output / "report.html");
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

/// What each part found, in the order of the paper; the tables are in their files.
std::string page_of(const Results& results, const OutputFormat& output, const Progress& progress) {
  constexpr std::array kParts = {ResultKind::certificates,
                                 ResultKind::h1,
                                 ResultKind::h2,
                                 ResultKind::h3,
                                 ResultKind::ablation,
                                 ResultKind::sweep,
                                 ResultKind::gate};
  const bool is_text = output.table_format() == TableFormat::text;
  std::string text;
  if (is_text && results.synthetic) {
    text += to_string(*results.synthetic) + "\n\n";
  }
  for (const ResultKind kind : kParts) {
    const Result* const result = results.find(kind);
    const auto findings = result != nullptr ? result_table(*result, "findings") : std::nullopt;
    if (findings) {
      text += (is_text ? findings_text(*findings, width_of(output, progress))
                       : shown(*findings, output, progress)) +
              '\n';
    }
  }
  return text;
}

/// The page of all results, if this build has one: its path is said last.
void write_page(const ReproduceRequest& request, Progress& progress) {
  ReportRequest page;
  page.results = request.output.path;
  page.bundle = request.bundle;
  page.threads = request.threads;
  page.output.path = (fs::path(request.output.path) / "report.html").string();
  try {
    static_cast<void>(report(page, progress));
  } catch (const NoInput& error) {
    progress.say(std::string("report.html is left out: ") + error.what());
  } catch (const BadData& error) {
    progress.say(std::string("report.html is left out: ") + error.what());
  }
}

}  // namespace

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
  progress.show(page_of(read_results(output), request.output, progress));
  progress.sum_up("Bundle:  " + bundle + "\nResults: " + output.string());
  write_page(request, progress);
  return steps.code();
}

}  // namespace tcert::cli
