#pragma once
/// \file
/// Where a report goes: back as text, into one file, or into a folder with every table in every
/// format.

#include <optional>
#include <string>

#include "cli/runs/progress.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/shared_options.hpp"
#include "reports/fit/fit_report.hpp"

namespace tcert::cli {

/// True if --output names a folder: it ends with '/', or is one.
[[nodiscard]] bool names_folder(const std::string& output);

/// True if the whole report is shown to people, with what was found and the conditions.
[[nodiscard]] bool shows_whole_report(const OutputOptions& output, const std::string& table);

/// A table, and below it what was found; in a format for programs that is said instead.
void show_found(const Table& table,
                const Table& findings,
                const OutputFormat& output,
                Progress& progress);

/// Says the findings.
void sum_up(const Table& findings, Progress& progress);
/// Says which one file was written and how a folder is asked for; of a folder and of stdout
/// nothing.
void say_one_file(const OutputOptions& output, Progress& progress);

/// <name>.csv, .json, .txt, .md and .tex of a table. \throws WriteError.
void write_table(const Table& table, const ResultFolder& folder);

class ReportOutput {
 public:
  /// \throws WriteError if a folder is asked for and may not be replaced.
  ReportOutput(const OutputOptions& output, const std::string& command);

  /// The report in the format, or only its table `table`: shown, or with a manifest beside the
  /// file; or the folder: every table in every format, details as CSV and JSON, the whole in
  /// report.json. What was found is said too where it is not in what is shown. \throws UsageError
  /// if there is no such table; WriteError.
  void deliver(FitReport report, const std::string& table, Manifest manifest, Progress& progress);

 private:
  void write_folder(FitReport report, Manifest manifest);

  const OutputOptions& output_;
  std::optional<ResultFolder> folder_;
};

}  // namespace tcert::cli
