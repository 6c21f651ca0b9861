#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/report/page_parts.hpp"
#include "cli/report/page_trials.hpp"
#include "cli/result_folder.hpp"
#include "reports/figure/figures_of.hpp"
#include "reports/html/page.hpp"
#include "reports/html/report_json.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(One page of a tree of results, to look at and to send: report.html, which needs no network.

Tables, figures with the numbers behind them, every trial (sorted, filtered, opened tick by tick
beside its map), every parameter that took effect, and the digests of all that was read and written.

RESULTS is a folder that a command wrote, or one that holds such folders. Results of different inputs
are refused. Trials need 'certify' (their courses: 'simulate' in the tree, or --bundle).

Usage: tcert report RESULTS [options]

Example:
  tcert report out/reproduce --output report.html
  tcert report out/results --bundle out/corpus --output report.html
  tcert report out/reproduce --output report.html --figures figures

Cost: two seconds and 6 MB of page for 660 trials.
)";

/// Every column keeps its peaks: fewer ticks than this would not be fewer.
constexpr double kFewestTicks = 60;

struct ReportOptions {
  std::string results;
  std::string bundle;
  std::string figures;
  std::string title = "Traversability certificates";
  std::int64_t ticks = 0;
};

CommandLine command_line(ReportOptions& o) {
  CommandLine line{"report",
                   kText,
                   uses_config | uses_output | uses_threads,
                   po::options_description("Options"),
                   {{"RESULTS", &o.results, true, OptionRole::input}}};
  line.own.add_options()("bundle",
                         input(o.bundle, "FOLDER"),
                         "the logs that the results were made from, for the courses on the maps; "
                         "needed if RESULTS does "
                         "not hold them")(
      "title",
      po::value(&o.title)->value_name("TEXT")->default_value(o.title),
      "the page's heading; change it to tell pages apart")(
      "ticks",
      po::value(&o.ticks)->value_name("N")->default_value(o.ticks),
      "most ticks of a trial on the page; 60 or more; more make it larger, 0 goes by the number of "
      "trials")("figures",
                output(o.figures, "DIR"),
                "also write the figures there for a paper, as 'tcert figures' does");
  return line;
}

/// share/tcert/page beside the program's own folder: in an installation and in a build alike.
std::filesystem::path page_folder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share" / "tcert" / "page";
}

PageAssets page_assets() {
  const std::filesystem::path folder = page_folder();
  std::error_code error;
  if (!std::filesystem::is_regular_file(folder / "page.js", error)) {
    throw NoInput(
        "this build has no report page: '" + (folder / "page.js").string() +
        "' is not there. It is made when Node.js and npm are installed and the npm registry "
        "can be reached; tables and figures need no page");
  }
  return read_page_assets(folder);
}

std::string lead_of(const Results& results, std::size_t trials, const PageContents& contents) {
  const auto some = [](std::size_t n, const std::string& one) {
    return std::to_string(n) + " " + one + (n == 1 ? "" : "s");
  };
  return some(trials, "trial") + ", " + some(contents.tables.size(), "table") + ", " +
         some(contents.figures.size(), "figure") + " from " + some(results.all.size(), "folder") +
         " of results.";
}

Results checked_results(const std::string& folder) {
  try {
    Results results = read_results(folder);
    // Drawn of the other results, as the page's own figures are.
    std::erase_if(results.all,
                  [](const Result& result) { return result.manifest.command == "figures"; });
    require_same_inputs(results);
    for (const Result& result : results.all) {
      if (const auto changed = first_difference(result.folder, result.manifest)) {
        throw BadData(
            "'" + result.name + "/" + *changed +
            "' is not as its manifest lists it: 'tcert verify' tells more; make the result "
            "again");
      }
    }
    // As a paper would have them, not by the names of folders.
    std::stable_sort(results.all.begin(), results.all.end(), [](const Result& a, const Result& b) {
      return a.kind < b.kind;
    });
    return results;
  } catch (const MissingResult& cause) {
    throw NoInput(cause.what());
  } catch (const MixedResults& cause) {
    throw BadData(cause.what());
  }
}

Manifest manifest_of(const Results& results, const CommonOptions& common) {
  Manifest manifest;
  manifest.command = "report";
  record(common, manifest);
  manifest.synthetic = results.synthetic;
  for (const Result& result : results.all) {
    const std::string name = result.name == "." ? "" : result.name + "/";
    manifest.inputs.push_back(
        {name + "manifest.json", digest_file(result.folder / "manifest.json")});
  }
  return manifest;
}

void add_figures(const Results& results, PageContents& contents) {
  StudyFigures study = study_figures(results);
  contents.figures = std::move(study.figures);
  for (const MissingFigure& missing : study.missing) {
    contents.left_out.push_back("No figure '" + missing.name + "': " + missing.reason);
  }
}

int run(Arguments arguments) {
  ReportOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  if (options.ticks != 0) {
    require_range("ticks", static_cast<double>(options.ticks), kFewestTicks, 1e6);
  }
  const std::string output = common.output.empty() ? "report.html" : common.output;
  require_own_file(output);
  table::require_output_place(options.figures);
  const PageAssets assets = page_assets();
  const Results results = checked_results(options.results);

  PageData page;
  PageContents contents;
  contents.title = options.title;
  contents.synthetic = results.synthetic;
  contents.results = results.all;
  contents.packages = assets.packages;
  contents.tables = page_tables(results, contents.left_out);
  contents.frames = page_frames(results, page);
  add_figures(results, contents);
  const std::size_t trials = add_trials(results,
                                        {options.bundle,
                                         static_cast<std::size_t>(options.ticks),
                                         static_cast<int>(common.threads),
                                         common.quiet},
                                        page,
                                        contents.left_out);
  contents.lead = lead_of(results, trials, contents);
  page.title = (contents.synthetic ? "SYNTHETIC: " : "") + options.title;
  page.report = report_json(contents);
  write_with_manifest(output, tcert::page(assets, page), manifest_of(results, common));
  if (!common.quiet) {
    say("Report: " + output);
  }
  if (!options.figures.empty()) {
    std::vector<std::string> words = {options.results, "--output", options.figures};
    if (common.quiet) {
      words.emplace_back("--quiet");
    }
    return kFigures.run(words);
  }
  return exit_done;
}

}  // namespace

const Command kReport = {"report", "one page of a tree of results, to look at and to send", run};

}  // namespace tcert::cli
