#include "datasets/check.hpp"

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/inputs.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "datasets/check_csv.hpp"
#include "reports/check_tables.hpp"
#include "reports/diagnostics_table.hpp"
#include "reports/features_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Check a bundle, or one CSV file of any origin, and list every problem on stdout with file, line,
column, value and what was expected.

Usage: tcert check BUNDLE|FILE.csv [options]

Example:
  tcert check corpus
  tcert check run7/pose.csv --format json
  tcert check my-logs --summary

Exit code: 0 if nothing was found, 1 if there are warnings or errors.
Cost: one pass over the logs, one trial in memory at a time.
)";

struct CheckFlags {
  std::string path;
  bool summary = false;
};

struct Findings {
  std::vector<Diagnostic> diagnostics;
  Table summary;
  std::optional<SyntheticLabel> synthetic;
};

CommandLine command_line(CheckFlags& o) {
  CommandLine line{"check",
                   kText,
                   uses_parameters | uses_format | uses_trials | uses_logs,
                   po::options_description("Options"),
                   {{"BUNDLE or FILE.csv", &o.path}}};
  line.own.add_options()(
      "summary",
      po::bool_switch(&o.summary),
      "print what the trials or columns hold instead; the problems go to stderr");
  return line;
}

/// A course without S or G is not wrong, but there is less to say about it.
void add_course_notes(const Course& course, std::vector<Diagnostic>& diagnostics) {
  const auto note = [&](const char* member, const char* expectation) {
    diagnostics.push_back({Severity::note, "bundle.json", 0, member, "", expectation, 1});
  };
  if (!course.start) {
    note("course.start", "a region S; without it S is a disc round the first node");
  }
  if (!course.goal) {
    note("course.goal", "a region G; without it there is V_t but no certificate T_t");
  }
}

Findings check_bundle_at(const std::string& path, const CommonOptions& common) {
  OpenedBundle opened = open_for(path, common, SayDiagnostics::no);
  Findings findings;
  findings.synthetic = synthetic_label(opened.bundle.info);
  findings.diagnostics = std::move(opened.diagnostics);
  add_course_notes(opened.bundle.info.course, findings.diagnostics);
  std::vector<TrialRow> chosen;
  for (const std::size_t trial : opened.trials) {
    chosen.push_back(std::move(opened.bundle.trials[trial]));
  }
  opened.bundle.trials = std::move(chosen);
  BundleCheck check = check_bundle(opened.bundle,
                                   {{common.repair},
                                    opened.parameters.resample,
                                    opened.parameters.certificate.travel_deadband_m});
  findings.diagnostics.insert(
      findings.diagnostics.end(), check.diagnostics.begin(), check.diagnostics.end());
  findings.summary = trials_table(check.trials);
  return findings;
}

Findings check_file_at(const std::string& path, const CommonOptions& common) {
  CsvCheckOptions options;
  options.decimal_comma = common.decimal_comma;
  CsvFileCheck check = check_csv_file(path, options);
  Findings findings;
  findings.diagnostics = std::move(check.diagnostics);
  if (check.summary) {
    findings.summary = columns_table(*check.summary);
  }
  return findings;
}

void print_problems(const Findings& findings, TableFormat format) {
  if (format == TableFormat::text) {
    for (const Diagnostic& diagnostic : findings.diagnostics) {
      print(to_string(diagnostic) + '\n');
    }
    return;
  }
  Table table = diagnostics_table(findings.synthetic);
  for (const Diagnostic& diagnostic : findings.diagnostics) {
    table.add_row(diagnostics_row("", diagnostic));
  }
  print(render(table, format));
}

int run(Arguments arguments) {
  CheckFlags options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  std::error_code error;
  if (!std::filesystem::exists(options.path, error)) {
    throw NoInput("nothing at '" + options.path + "'");
  }
  const bool is_bundle = std::filesystem::is_directory(options.path, error) ||
                         std::filesystem::path(options.path).extension() == ".zip";
  Findings findings =
      is_bundle ? check_bundle_at(options.path, common) : check_file_at(options.path, common);
  if (options.summary) {
    findings.summary.synthetic = findings.synthetic;
    say(findings.diagnostics);
    print(render(findings.summary, common.table_format()));
  } else {
    print_problems(findings, common.table_format());
  }
  const auto problems = std::count_if(
      findings.diagnostics.begin(), findings.diagnostics.end(), [](const Diagnostic& diagnostic) {
        return diagnostic.severity != Severity::note;
      });
  if (!common.quiet) {
    say(options.path + ": " + std::to_string(problems) +
        (problems == 1 ? " problem." : " problems."));
  }
  return problems == 0 ? exit_done : exit_differences;
}

}  // namespace

const Command kCheck = {"check", "list the problems of a bundle or a CSV file", run};

}  // namespace tcert::cli
