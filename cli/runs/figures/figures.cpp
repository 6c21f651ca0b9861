#include "cli/runs/figures/figures.hpp"

#include <utility>

#include "cli/runs/data_file.hpp"
#include "cli/runs/figures/write_figures.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {
OptionTable options_of(FiguresRequest& request) {
  OptionTable table(request.given);
  table.argument({"RESULTS", &request.results, true, OptionRole::input});
  table.add("trials",
            request.trials,
            "IDS",
            "trials whose series and map are drawn, comma between; unless given a middling one, "
            "the tightest and the first failure");
  add_common(table, request);
  return table;
}

ExitCode figures(const FiguresRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output DIR");
  }
  require_apart(request.results, output);
  FigureFiles files;
  try {
    const Results results = read_results(request.results);
    require_same_inputs(results);
    ResultFolder folder(output, "figures");
    const std::vector<std::string> trials =
        request.trials.empty() ? typical_trials(results) : words_of(request.trials);
    files = write_figures(results, trials, folder);
    Manifest manifest;
    manifest.command = "figures";
    record(written(request), manifest);
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
    progress.say(missing.name + " is left out: " + missing.reason);
  }
  if (!files.drawn) {
    progress.say("No SVG and PDF: gnuplot is not installed (Debian's package is gnuplot-nox).");
  }
  progress.sum_up(std::to_string(files.figures) + " figures in " + output);
  return exit_done;
}

}  // namespace tcert::cli
