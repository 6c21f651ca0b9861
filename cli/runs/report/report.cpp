#include "cli/runs/report/report.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/runs/figures/figures.hpp"
#include "cli/runs/report/page_parts.hpp"
#include "cli/runs/report/page_trials.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/written_options.hpp"
#include "reports/figure/figures_of.hpp"
#include "reports/html/page.hpp"
#include "reports/html/report_json.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {
namespace {

/// Every column keeps its peaks: fewer ticks than this would not be fewer.
constexpr double kFewestTicksOfAPage = 60;

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

/// What dealt trials and driven ones can show, where a page has both.
constexpr const char* kDealtAndDriven =
    " Of dealt trials it is given which fail, and their gates are drawn to it: they show that the "
    "chain of methods works. Driven trials, whose own page is driven/report.html, meet gates that "
    "know no outcome: what comes out is of policies after published descriptions in declared "
    "worlds. "
    "Neither says anything about a robot.";

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

/// Appends what a tree within the results holds, each title with the word before it.
void add_tree(const Results& tree, const std::string& word, PageContents& contents) {
  for (PageFindings& one : page_findings(tree)) {
    one.title = word + ": " + one.title;
    contents.findings.push_back(std::move(one));
  }
  for (PageTable& one : page_tables(tree, contents.left_out)) {
    one.group = word + ": " + one.group;
    one.table.title = word + ": " + one.table.title;
    one.source = tree.folder.filename().string() + "/" + one.source;
    contents.tables.push_back(std::move(one));
  }
  for (Result result : tree.all) {
    result.name = tree.folder.filename().string() + "/" + result.name;
    contents.results.push_back(std::move(result));
  }
}

/// The trials that `reproduce` has driven; empty if it has driven none.
std::optional<Results> driven_tree(const Results& results) {
  const std::filesystem::path folder = results.folder / "driven";
  std::error_code error;
  if (!std::filesystem::is_regular_file(folder / "certificates" / "manifest.json", error)) {
    return std::nullopt;
  }
  return checked_results(folder.string());
}

/// \throws NoInput if there is neither a table, short or long, nor a frame: the page would be
/// empty.
void require_something(const Results& results, const PageContents& contents) {
  if (!contents.findings.empty() || !contents.tables.empty() || !contents.frames.empty() ||
      !contents.left_out.empty()) {
    return;
  }
  std::set<std::string> commands;
  for (const Result& result : results.all) {
    commands.insert("'tcert " + result.manifest.command + "'");
  }
  std::string wrote;
  for (const std::string& command : commands) {
    wrote += (wrote.empty() ? "" : ", ") + command;
  }
  throw NoInput(
      "'" + results.folder.string() + "' holds no table, only what " +
      (wrote.empty() ? "'tcert figures'" : wrote) +
      " wrote; 'tcert certify BUNDLE --output DIR' makes the tables of the trials, 'tcert "
      "hypotheses', 'ablate', 'gate' and 'study' those of their results, 'tcert reproduce' "
      "all of them");
}

Manifest manifest_of(const Results& results, const ReportRequest& request) {
  Manifest manifest;
  manifest.command = "report";
  record(written(request), manifest);
  manifest.synthetic = results.synthetic;
  for (const Result& result : results.all) {
    const std::string name = result.name == "." ? "" : result.name + "/";
    manifest.inputs.push_back(
        {name + "manifest.json", digest_file(result.folder / "manifest.json")});
  }
  return manifest;
}

/// The map of a typical trial, as an example of a course and of what was touched on it.
std::optional<Figure> course_figure(const Results& results) {
  for (const std::string& trial : typical_trials(results)) {
    if (const std::optional<TrialPicture> picture = trial_picture(results, trial)) {
      if (std::optional<Figure> map = trial_map_figure(*picture)) {
        map->title = "The course of one trial, " + trial + ", and its contacts";
        return map;
      }
    }
  }
  return std::nullopt;
}

void add_figures(const Results& results, PageContents& contents) {
  StudyFigures study = study_figures(results);
  contents.figures = std::move(study.figures);
  for (const MissingFigure& missing : study.missing) {
    contents.left_out.push_back("No figure '" + missing.name + "': " + missing.reason);
  }
  if (std::optional<Figure> course = course_figure(results)) {
    contents.figures.push_back(std::move(*course));
  }
}

}  // namespace

OptionTable options_of(ReportRequest& request) {
  OptionTable table(request.given);
  table.argument({"RESULTS", &request.results, true, OptionRole::input});
  table.add_input(
      "bundle",
      request.bundle,
      "FOLDER",
      "the logs that the results were made from, for the courses on the maps; needed if "
      "RESULTS does not hold them");
  table.add("title", request.title, "TEXT", "the page's heading; change it to tell pages apart");
  table.add("ticks",
            request.ticks,
            "N",
            "most ticks of a trial on the page; 60 or more; more make it larger, 0 goes by the "
            "number of trials");
  table.add_output("figures",
                   request.figures,
                   "DIR",
                   "also write the figures there for a paper, as 'tcert figures' does");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode report(const ReportRequest& request, Progress& progress) {
  if (request.ticks != 0) {
    require_range("ticks", static_cast<double>(request.ticks), kFewestTicksOfAPage, 1e6);
  }
  const std::string output = request.output.path.empty() ? "report.html" : request.output.path;
  require_own_file(output);
  table::require_output_place(request.figures);
  const Results results = checked_results(request.results);

  PageData page;
  PageContents contents;
  contents.title = request.title;
  contents.synthetic = results.synthetic;
  contents.results = results.all;
  contents.findings = page_findings(results);
  contents.tables = page_tables(results, contents.left_out);
  const std::optional<Results> driven = driven_tree(results);
  if (driven) {
    add_tree(*driven, "Driven", contents);
  }
  contents.frames = page_frames(results, page);
  require_something(results, contents);
  const PageAssets assets = page_assets();
  contents.packages = assets.packages;
  add_figures(results, contents);
  const std::size_t trials = add_trials(
      results,
      {request.bundle, static_cast<std::size_t>(request.ticks), static_cast<int>(request.threads)},
      progress,
      page,
      contents.left_out);
  contents.lead = lead_of(results, trials, contents) + (driven ? kDealtAndDriven : "");
  page.title = (contents.synthetic ? "SYNTHETIC: " : "") + request.title;
  page.report = report_json(contents);
  Manifest manifest = manifest_of(results, request);
  for (const Result& result : driven ? driven->all : std::vector<Result>()) {
    manifest.inputs.push_back(
        {"driven/" + result.name + "/manifest.json", digest_file(result.folder / "manifest.json")});
  }
  write_with_manifest(output, tcert::page(assets, page), std::move(manifest));
  progress.sum_up("Report: " + output);
  if (request.figures.empty()) {
    return exit_done;
  }
  FiguresRequest drawn;
  drawn.results = request.results;
  drawn.output.path = request.figures;
  return figures(drawn, progress);
}

}  // namespace tcert::cli
