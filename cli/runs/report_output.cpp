#include "cli/runs/report_output.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/runs/data_file.hpp"
#include "cli/runs/progress.hpp"

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

ReportOutput::ReportOutput(const OutputOptions& output, const std::string& command)
    : output_(output) {
  if (names_folder(output.path)) {
    folder_.emplace((std::filesystem::path(output.path) / "").parent_path(), command);
  } else {
    require_own_file(output.path);
  }
}

std::string ReportOutput::deliver(FitReport report, const std::string& table, Manifest manifest) {
  require_table(report, table);
  if (!folder_) {
    std::string text = render(report, output_.table_format(), table);
    if (!output_.path.empty()) {
      write_with_manifest(output_.path, text, std::move(manifest));
      text.clear();
    }
    return text;
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
  return "";
}

}  // namespace tcert::cli
