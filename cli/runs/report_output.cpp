#include "cli/report_output.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/data_file.hpp"
#include "cli/output.hpp"

namespace tcert::cli {

bool names_folder(const std::string& output) {
  std::error_code error;
  return !output.empty() && (output.back() == '/' || std::filesystem::is_directory(output, error));
}

void write_table(const Table& table, const ResultFolder& folder) {
  folder.write(table.name + ".txt", render(table, TableFormat::text));
  folder.write(table.name + ".md", render(table, TableFormat::markdown));
  folder.write(table.name + ".tex", render(table, TableFormat::latex));
  folder.write(table.name + ".csv", render(table, TableFormat::csv));
  folder.write(table.name + ".json", render(table, TableFormat::json));
}

ReportOutput::ReportOutput(const CommonOptions& common, const std::string& command)
    : common_(common) {
  if (names_folder(common.output)) {
    folder_.emplace((std::filesystem::path(common.output) / "").parent_path(), command);
  } else {
    require_own_file(common.output);
  }
}

void ReportOutput::deliver(FitReport report, const std::string& table, Manifest manifest) {
  require_table(report, table);
  if (!folder_) {
    const std::string text = render(report, common_.table_format(), table);
    if (common_.output.empty()) {
      print(text);
    } else {
      write_with_manifest(common_.output, text, std::move(manifest));
    }
    return;
  }
  folder_->write("report.json", render(report, TableFormat::json));
  const auto labelled = [&](Table& one) -> const Table& {
    one.synthetic = report.synthetic;
    return one;
  };
  for (Table& one : report.tables) {
    write_table(labelled(one), *folder_);
  }
  report.details.push_back(report.summary);
  for (Table& one : report.details) {
    folder_->write(one.name + ".csv", render(labelled(one), TableFormat::csv));
    folder_->write(one.name + ".json", render(one, TableFormat::json));
  }
  folder_->commit(std::move(manifest));
}

}  // namespace tcert::cli
