#include "cli/runs/report_output.hpp"

#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

#include "cli/runs/data_file.hpp"
#include "reports/findings.hpp"
#include "reports/text_width.hpp"

namespace tcert::cli {

bool names_folder(const std::string& output) {
  std::error_code error;
  return !output.empty() && (output.back() == '/' || std::filesystem::is_directory(output, error));
}

void say_one_file(const OutputOptions& output, Progress& progress) {
  if (!output.path.empty() && !names_folder(output.path)) {
    progress.sum_up("'" + output.path + "' is one file, in the format " + output.format + "; '" +
                    output.path + "/' would be a folder with every table in every format.");
  }
}

void write_table(const Table& table, const ResultFolder& folder) {
  folder.write(table.name + ".txt", render(table, TableFormat::text));
  folder.write(table.name + ".md", render(table, TableFormat::markdown));
  folder.write(table.name + ".tex", render(table, TableFormat::latex));
  folder.write(table.name + ".csv", render(table, TableFormat::csv));
  folder.write(table.name + ".json", render(table, TableFormat::json));
}

namespace {

/// What takes numbers away, for those who do not see the report: in full if it takes them all, else
/// by its name.
void say_conditions(const statistics::Conditions& conditions, Progress& progress) {
  statistics::Conditions whole;
  std::set<std::string_view> named;
  std::string names;
  for (const statistics::Condition& one : conditions) {
    const std::string_view name = words(one.kind);
    if (one.severity == statistics::ConditionSeverity::error ||
        one.kind == statistics::ConditionKind::withheld) {
      whole.push_back(one);
    } else if (one.severity == statistics::ConditionSeverity::warning &&
               named.insert(name).second) {
      names += names.empty() ? "" : ", ";
      names += name;
    }
  }
  std::string lines = conditions_text(whole, progress.width());
  if (!names.empty()) {
    lines += wrapped("warning: " + names + "; the conditions, in the text or in JSON, say where.\n",
                     progress.width());
  }
  if (!lines.empty()) {
    lines.pop_back();  // The last line feed.
    progress.say(lines);
  }
}

}  // namespace

ReportOutput::ReportOutput(const OutputOptions& output, const std::string& command)
    : output_(output) {
  if (names_folder(output.path)) {
    folder_.emplace((std::filesystem::path(output.path) / "").parent_path(), command);
  } else {
    require_own_file(output.path);
  }
}

void ReportOutput::deliver(FitReport report,
                           const std::string& table,
                           Manifest manifest,
                           Progress& progress) {
  require_table(report, table);
  const TableFormat format = output_.table_format();
  const Table findings = report.findings;
  const statistics::Conditions conditions = report.conditions;
  if (folder_) {
    write_folder(std::move(report), std::move(manifest));
  } else if (!output_.path.empty()) {
    write_with_manifest(output_.path, render(report, format, table), std::move(manifest));
  } else {
    progress.show(render(report, format, table, width_of(output_, progress)));
  }
  if (!shows_whole_report(output_, table)) {
    say_conditions(conditions, progress);
    sum_up(findings, progress);
  }
}

void ReportOutput::write_folder(FitReport report, Manifest manifest) {
  folder_->write("report.json", render(report, TableFormat::json));
  const auto labelled = [&](Table& one) -> const Table& {
    one.synthetic = report.synthetic;
    return one;
  };
  if (!report.findings.rows.empty()) {
    report.tables.push_back(report.findings);
  }
  for (Table& one : report.tables) {
    write_table(labelled(one), *folder_);
  }
  report.details.push_back(report.summary);
  if (!report.conditions.empty()) {
    report.details.push_back(all_conditions_table(report.conditions));
  }
  for (Table& one : report.details) {
    folder_->write(one.name + ".csv", render(labelled(one), TableFormat::csv));
    folder_->write(one.name + ".json", render(one, TableFormat::json));
  }
  for (const Attachment& one : report.attachments) {
    folder_->write(one.name + "." + one.ending, one.text);
  }
  folder_->commit(std::move(manifest));
}

bool shows_whole_report(const OutputOptions& output, const std::string& table) {
  const TableFormat format = output.table_format();
  return output.path.empty() && table.empty() &&
         (format == TableFormat::text || format == TableFormat::markdown);
}

void show_found(const Table& table,
                const Table& findings,
                const OutputFormat& output,
                Progress& progress) {
  std::string text = shown(table, output, progress);
  if (output.table_format() == TableFormat::text) {
    text += '\n' + findings_text(findings, width_of(output, progress));
    progress.show(text);
    return;
  }
  progress.show(text);
  sum_up(findings, progress);
}

void sum_up(const Table& findings, Progress& progress) {
  std::string lines = findings_text(findings, progress.width());
  if (!lines.empty()) {
    lines.pop_back();  // The last line feed.
    progress.sum_up(lines);
  }
}

}  // namespace tcert::cli
