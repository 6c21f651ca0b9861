#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <table/csv_write.hpp>
#include <utility>
#include <vector>

#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "cli/simulated.hpp"
#include "datasets/corpus/tentacles.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kText =
    R"(From end to end: logs, certificates, features, every hypothesis, every table.

Without a BUNDLE it makes the synthetic corpus in DIR/corpus, and the gate passes of the micro-study
in DIR/gates, unless they are there already. Then it runs the other commands, each into its folder:

  DIR/certificates  tcert certify     DIR/h1       tcert hypotheses h1 on its features.csv
  DIR/replays       tcert replay      DIR/h2       tcert hypotheses h2 likewise
  DIR/ablation      tcert ablate      DIR/h3       tcert hypotheses h3 on replays/replay.csv
  DIR/gate          tcert gate        DIR/sensitivity  tcert sweep --sensitivity, if asked for

and prints the tables; DIR/report.html (tcert report) shows all of it. A step that the data do not
allow (no lighting, no baseline) is left out and named. What an earlier run left in DIR and this one
does not make is removed; if it was edited, nothing is done. 'tcert verify DIR' makes everything again and compares it.

Usage: tcert reproduce [BUNDLE] --output DIR [options]

Example:
  tcert reproduce --output results
  tcert reproduce my-logs --output results --set body_width_m=0.5

Cost: a quarter of a minute and about 200 MB for the 660 trials; a minute more with --sensitivity.
)";

struct ReproduceOptions {
  std::string bundle;
  double effect = 1.0;
  bool no_series = false;
  bool sensitivity = false;
};

CommandLine command_line(ReproduceOptions& o) {
  CommandLine line{"reproduce",
                   kText,
                   uses_parameters | uses_output | uses_format | uses_seed | uses_threads |
                       uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"BUNDLE", &o.bundle, false, OptionRole::input}}};
  line.own.add_options()("effect",
                         po::value(&o.effect)->value_name("E")->default_value(o.effect),
                         "of the corpus, as for 'tcert simulate'; 0 makes a null corpus")(
      "no-series", po::bool_switch(&o.no_series), "leave certificates/series out, to save space")(
      "sensitivity",
      po::bool_switch(&o.sensitivity),
      "also run under every choice that the paper leaves open, one at a time");
  return line;
}

/// Makes it unless it is there.
std::string corpus_in(const fs::path& folder,
                      bool micro_study,
                      const ReproduceOptions& options,
                      const CommonOptions& common) {
  SimulatedCorpus corpus;
  corpus.micro_study = micro_study;
  corpus.options.seed = static_cast<std::uint64_t>(common.seed);
  corpus.options.effect = options.effect;
  if (!is_there(corpus, folder)) {
    write_corpus(corpus, folder, common);
  }
  return folder.string();
}

using Words = std::vector<std::string>;

/// The commands of the study, one after the other.
class Steps {
 public:
  Steps(const CommonOptions& common, fs::path folder)
      : common_(common), folder_(std::move(folder)) {}

  /// What every command is told.
  [[nodiscard]] Words of_process() const {
    Words words = {"--threads", std::to_string(common_.threads)};
    if (common_.quiet) {
      words.emplace_back("--quiet");
    }
    return words;
  }

  /// What is told to those that read the logs.
  [[nodiscard]] Words of_logs() const {
    Words words = of_process();
    const std::pair<bool, const char*> flags[] = {{common_.strict, "--strict"},
                                                  {common_.repair, "--repair"},
                                                  {common_.decimal_comma, "--decimal-comma"}};
    for (const auto& [given, name] : flags) {
      if (given) {
        words.emplace_back(name);
      }
    }
    if (!common_.trials.empty()) {
      words.insert(words.end(), {"--trials", common_.trials});
    }
    for (const Settings* parameters : {&common_.file_parameters, &common_.flag_parameters}) {
      for (const auto& [key, value] : *parameters) {
        words.insert(words.end(), {"--set", key + "=" + value});
      }
    }
    return words;
  }

  [[nodiscard]] Words seed() const { return {"--seed", std::to_string(common_.seed)}; }

  /// Must go well.
  void require(const Command& command, Words words, const char* part) {
    const int code = command.run(with_output(std::move(words), part));
    if (code != exit_done && code != exit_rejected) {
      throw BadData("'tcert " + std::string(command.name) + "' could not make " +
                    (folder_ / part).string());
    }
    note(code);
  }

  /// May be impossible with these data.
  void attempt(const Command& command, Words words, const char* part) {
    try {
      const int code = command.run(with_output(std::move(words), part));
      if (code == exit_bad_data) {
        say(std::string(part) + ": conditions were met, see " + (folder_ / part).string());
      } else {
        note(code);
      }
    } catch (const BadData& error) {
      leave_out(command, part, error);
    } catch (const UsageError& error) {
      leave_out(command, part, error);
    }
  }

  [[nodiscard]] int exit_code() const noexcept { return exit_code_; }

 private:
  [[nodiscard]] Words with_output(Words words, const char* part) const {
    words.insert(words.end(), {"--output", (folder_ / part / "").string()});
    return words;
  }
  /// Nothing of an earlier run stands for it.
  void leave_out(const Command& command, const char* part, const std::exception& error) const {
    remove_own_folder(folder_ / part, std::string(command.name));
    say(std::string(part) + " is left out: " + error.what());
  }
  void note(int code) { exit_code_ = std::max(exit_code_, code); }

  const CommonOptions& common_;
  fs::path folder_;
  int exit_code_ = exit_done;
};

Words joined(std::initializer_list<Words> parts) {
  Words all;
  for (const Words& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

/// Where the landmark of the features is, if not where it usually is.
Words landmark_of(const OpenedBundle& opened) {
  const double time_s = opened.parameters.early_window.time_s;
  if (time_s == study::ParameterSet().early_window.time_s) {
    return {};
  }
  std::string text;
  table::append_number(text, time_s);
  return {"--landmark", text};
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
void remove_stale(const fs::path& output, const ReproduceOptions& options) {
  std::vector<std::pair<fs::path, const char*>> folders;
  if (!options.sensitivity) {
    folders.emplace_back(output / "sensitivity", "sweep");
  }
  if (!options.bundle.empty()) {
    folders.emplace_back(output / "gate", "gate");
    for (const char* const part : {"gates", "corpus"}) {
      if (!lies_in(options.bundle, output / part)) {
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
void require_readable(const ReproduceOptions& options, const CommonOptions& common) {
  if (options.bundle.empty()) {
    BundleInfo corpus;
    corpus.robot = corpus_robot();
    static_cast<void>(effective_robot(corpus, effective_parameters({}, common)));
  } else {
    const OpenedBundle opened = open_for(options.bundle, common, SayDiagnostics::no);
    static_cast<void>(effective_robot(opened.bundle.info, opened.parameters));
    for (const char* part : {"certificates", "replays", "ablation", "sensitivity"}) {
      require_apart(options.bundle, fs::path(common.output) / part);
    }
  }
}

/// The tables that people read, in the order of the paper.
void print_tables(const fs::path& folder, TableFormat format) {
  const std::pair<ResultKind, std::vector<const char*>> shown[] = {
      {ResultKind::certificates, {"table1", "speed", "latency"}},
      {ResultKind::h1,
       {"issued", "tc_early", "h1", "h1_within", "h1_time", "h1_time_within", "h1_mixed"}},
      {ResultKind::h2, {"h2", "h2_within", "h2_equality"}},
      {ResultKind::h3, {"h3", "h3_baseline"}},
      {ResultKind::gate, {"gate"}}};
  const Results results = read_results(folder);
  for (const auto& [kind, names] : shown) {
    const Result* const result = results.find(kind);
    for (const char* const name : names) {
      if (const auto table = result != nullptr ? result_table(*result, name) : std::nullopt) {
        print(render(*table, format) + '\n');
      }
    }
  }
}

/// The page of all results, if this build has one: its path is said last.
void write_page(const fs::path& folder, const std::string& bundle, const Steps& steps) {
  Words words = joined(
      {{folder.string()}, steps.of_process(), {"--output", (folder / "report.html").string()}});
  if (!bundle.empty()) {
    words.insert(words.end(), {"--bundle", bundle});
  }
  try {
    kReport.run(words);
  } catch (const NoInput& error) {
    say(std::string("report.html is left out: ") + error.what());
  } catch (const BadData& error) {
    say(std::string("report.html is left out: ") + error.what());
  }
}

int run(Arguments arguments) {
  ReproduceOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  require_range("effect", options.effect, 0, 2);
  if (common.output.empty()) {
    throw UsageError("needs --output DIR");
  }
  const bool own_corpus = options.bundle.empty();
  const fs::path output = common.output;
  require_readable(options, common);
  // Then at once, for it finishes a page whose manifest was written and lacks its name alone.
  remove_stale(output, options);
  table::sweep_leftovers_in(output);
  const std::string bundle =
      own_corpus ? corpus_in(output / "corpus", false, options, common) : options.bundle;
  const Words landmark = landmark_of(open_for(bundle, common, SayDiagnostics::no));

  Steps steps(common, output);
  const Words features = {"--features", (output / "certificates" / "features.csv").string()};
  const Words replays = {"--replays", (output / "replays" / "replay.csv").string()};
  steps.require(
      kCertify,
      joined({{bundle}, steps.of_logs(), options.no_series ? Words{"--no-series"} : Words{}}),
      "certificates");
  const Words test = joined({steps.of_process(), steps.seed()});
  steps.attempt(kHypotheses, joined({{"h1"}, features, landmark, test}), "h1");
  steps.attempt(kHypotheses, joined({{"h2"}, features, landmark, test}), "h2");
  steps.require(kReplay, joined({{bundle}, steps.of_logs()}), "replays");
  steps.attempt(kHypotheses, joined({{"h3"}, replays, test}), "h3");
  const Words batch = joined({{bundle}, steps.of_logs(), steps.seed()});
  steps.attempt(kAblate, batch, "ablation");
  if (options.sensitivity) {
    steps.attempt(kSweep, joined({batch, {"--sensitivity"}}), "sensitivity");
  }
  if (own_corpus) {
    const std::string gates = corpus_in(output / "gates", true, options, common);
    steps.attempt(kGate, joined({{gates}, test}), "gate");
  }
  print_tables(output, common.table_format());
  if (!common.quiet) {
    say("Bundle:  " + bundle + "\nResults: " + output.string());
  }
  write_page(output, own_corpus ? "" : bundle, steps);
  return steps.exit_code();
}

}  // namespace

const Command kReproduce = {"reproduce", "from logs to the tables of the paper, end to end", run};

}  // namespace tcert::cli
