#include <utility>

#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/figures/write_figures.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Draw the figures of results for a paper.

RESULTS is a folder as 'tcert reproduce' makes it, or any folder of folders that the commands wrote.
Every figure that they allow goes to DIR as Vega-Lite (NAME.vl.json), its data (NAME.csv), a gnuplot
script (NAME.gp) and, where gnuplot is installed, SVG and PDF; what is missing is said. The scripts
read the CSV beside them: 'gnuplot -c roc.gp pdf'.

Usage: tcert figures RESULTS --output DIR [options]

Example:
  tcert figures results --output figures
  tcert figures results --output figures --trials t0000007,t0000012

Cost: a few seconds.
)";

struct FiguresOptions {
  std::string results;
  std::string trials;
};

int run(Arguments arguments) {
  FiguresOptions options;
  CommonOptions common;
  CommandLine line{"figures",
                   kText,
                   uses_output,
                   po::options_description("Options"),
                   {{"RESULTS", &options.results, true, OptionRole::input}}};
  line.own.add_options()("trials",
                         po::value(&options.trials)->value_name("IDS"),
                         "trials whose series and map are drawn, comma between; unless given a "
                         "middling one, the tightest and the first failure");
  if (!parse(line, common, arguments)) {
    return exit_done;
  }
  if (common.output.empty()) {
    throw UsageError("needs --output DIR");
  }
  require_apart(options.results, common.output);
  FigureFiles files;
  try {
    const Results results = read_results(options.results);
    require_same_inputs(results);
    ResultFolder folder(common.output, "figures");
    const std::vector<std::string> trials =
        options.trials.empty() ? typical_trials(results) : words_of(options.trials);
    files = write_figures(results, trials, folder);
    Manifest manifest;
    manifest.command = "figures";
    record(common, manifest);
    manifest.synthetic = results.synthetic;
    for (const Result& result : results.all) {
      if (result.kind == ResultKind::other) {
        continue;  // Perhaps the figures of the last time.
      }
      manifest.inputs.push_back(
          {result.name + "/manifest.json", digest_file(result.folder / "manifest.json")});
    }
    folder.commit(std::move(manifest));
  } catch (const MissingResult& error) {
    throw NoInput(error.what());
  } catch (const MixedResults& error) {
    throw BadData(error.what());
  }
  for (const MissingFigure& missing : files.missing) {
    say(missing.name + " is left out: " + missing.reason);
  }
  if (!files.drawn) {
    say("No SVG and PDF: gnuplot is not installed (Debian's package is gnuplot-nox).");
  }
  if (!common.quiet) {
    say(std::to_string(files.figures) + " figures in " + common.output);
  }
  return exit_done;
}

}  // namespace

const Command kFigures = {"figures", "draw the figures of results for a paper", run};

}  // namespace tcert::cli
