#include "cli/runs/report/report.hpp"

#include "cli/commands/run_command.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kReportText =
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

int run_report(Arguments arguments) { return run_command(kReportText, arguments, report); }

std::vector<CommandForm> report_forms() { return {form_for<ReportRequest>(kReportText)}; }

}  // namespace

const Command kReport = {
    "report", "one page of a tree of results, to look at and to send", run_report, report_forms};

}  // namespace tcert::cli
