#include "cli/runs/reproduce_page.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cli/runs/report/report.hpp"
#include "cli/runs/reproduce_driven.hpp"
#include "reports/findings.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

bool is_of(const std::vector<TableCell>& finding, std::string_view panel) {
  return std::get<std::string>(finding[0]).find(panel) != std::string::npos;
}

/// What fits a page: of two panels the one from which conclusions are drawn, and each rule once.
Table shortened(Table findings, std::set<std::string>& said) {
  const auto is_panel = [](std::string_view panel) {
    return [panel](const auto& finding) { return is_of(finding, panel); };
  };
  if (std::ranges::any_of(findings.rows, is_panel("landmark panel"))) {
    std::erase_if(findings.rows, is_panel("paper panel"));
  }
  std::erase_if(findings.footnotes,
                [&said](const std::string& rule) { return !said.insert(rule).second; });
  return findings;
}

/// What each part found, in the order of the paper; the tables are in their files. `said` are the
/// rules that stand above.
std::string page_of(const Results& results,
                    const OutputFormat& output,
                    const Progress& progress,
                    std::set<std::string>& said) {
  constexpr std::array kParts = {ResultKind::certificates,
                                 ResultKind::h1,
                                 ResultKind::h2,
                                 ResultKind::h3,
                                 ResultKind::h3_driven,
                                 ResultKind::ablation,
                                 ResultKind::sweep,
                                 ResultKind::gate,
                                 ResultKind::assurance,
                                 ResultKind::guards};
  const bool is_text = output.table_format() == TableFormat::text;
  std::string text;
  for (const ResultKind kind : kParts) {
    const Result* const result = results.find(kind);
    const auto findings = result != nullptr ? result_table(*result, "findings") : std::nullopt;
    if (findings) {
      text += (is_text ? findings_text(shortened(*findings, said), width_of(output, progress))
                       : shown(*findings, output, progress)) +
              '\n';
    }
  }
  return text;
}

}  // namespace

std::string pages_of(const ReproduceRequest& request, const Progress& progress) {
  const fs::path output = request.output.path;
  const Results results = read_results(output);
  std::set<std::string> said;
  const bool is_text = request.output.table_format() == TableFormat::text;
  std::string text;
  if (is_text && results.synthetic) {
    text += to_string(*results.synthetic) + "\n\n";
  }
  std::error_code missing;  // where it was left out
  if (!drives(request) || !fs::exists(output / "driven" / "certificates", missing)) {
    return text + page_of(results, request.output, progress, said);
  }
  const auto heading = [&](const char* words) {
    return is_text ? std::string(words) + "\n\n" : std::string();
  };
  text += heading("Dealt trials: which of them fail is given, and their gates are drawn to it.");
  text += page_of(results, request.output, progress, said) + '\n';
  text += heading("Driven trials: policies in closed loop through gates that know no outcome.");
  return text + page_of(read_results(output / "driven"), request.output, progress, said);
}

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

}  // namespace tcert::cli
