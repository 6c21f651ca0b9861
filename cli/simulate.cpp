#include "cli/simulated.hpp"

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "cli/simulate_terrain.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make the synthetic corpus: a bundle with everything that the paper publishes about its 660 trials
built in, and everything else declared. It tests and shows the tool; it says nothing about a robot.

Usage: tcert simulate --output DIR [options]
       tcert simulate terrain --output FILE [options]   (see 'tcert simulate terrain --help')

Example:
  tcert simulate --output corpus
  tcert simulate --output null --effect 0 --seed 7
  tcert simulate --output gates --micro-study

Cost: about 2 ms and 115 kB a trial (five times that at native rates).
)";

struct SimulateOptions {
  std::int64_t trials = 660;
  double effect = 1.0;
  bool native_rates = false;
  bool micro_study = false;
};

CommandLine command_line(SimulateOptions& o) {
  CommandLine line{"simulate",
                   kText,
                   uses_output | uses_seed | uses_threads | uses_config,
                   po::options_description("Options"),
                   {}};
  line.own.add_options()("trials",
                         po::value(&o.trials)->value_name("N")->default_value(o.trials),
                         "another number for tests of scaling; blocks of 660 are alike")(
      "effect",
      po::value(&o.effect)->value_name("E")->default_value(o.effect),
      "how far successes and failures lie apart, 0 to 2; 0 makes a null corpus")(
      "native-rates",
      po::bool_switch(&o.native_rates),
      "streams at 83, 50 and 20 Hz, as the robot logs them, instead of 20 Hz")(
      "micro-study",
      po::bool_switch(&o.micro_study),
      "the 60 passes through gates about as wide as the body instead of the corpus");
  return line;
}

int run(Arguments arguments) {
  if (!arguments.empty() && arguments.front() == "terrain") {
    return simulate_terrain(arguments.subspan(1));
  }
  SimulateOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  require_range("trials", static_cast<double>(options.trials), 1, 1e8);
  require_range("effect", options.effect, 0, 2);
  if (common.output.empty()) {
    throw UsageError("needs --output DIR");
  }
  SimulatedCorpus corpus;
  corpus.options.seed = static_cast<std::uint64_t>(common.seed);
  corpus.options.trials = static_cast<std::uint64_t>(options.trials);
  corpus.options.effect = options.effect;
  corpus.options.native_rates = options.native_rates;
  corpus.micro_study = options.micro_study;
  const std::uint64_t made = write_corpus(corpus, common.output, common);
  if (!common.quiet) {
    say(to_string(SyntheticLabel{corpus.options.seed}) + " " + std::to_string(made) +
        " trials in " + common.output + ".");
  }
  return exit_done;
}

}  // namespace

const Command kSimulate = {"simulate", "make the synthetic corpus", run};

}  // namespace tcert::cli
