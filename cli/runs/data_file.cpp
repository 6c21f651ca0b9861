#include "cli/runs/data_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <table/read_data_table.hpp>

#include "cli/runs/errors.hpp"
#include "cli/runs/result_folder.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kSeedColumn = "synthetic_seed";

/// "-1,5".
bool has_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  if (comma == std::string_view::npos) {
    return false;
  }
  std::string text(cell);
  text[comma] = '.';
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && stop == text.data() + text.size();
}

void suggest_decimal_comma(const table::DataTable& table, Progress& progress) {
  for (const table::DataColumn& column : table.columns) {
    const auto& levels = column.text.levels;
    const auto found = std::find_if(levels.begin(), levels.end(), has_decimal_comma);
    if (found != levels.end()) {
      std::string line = "note: " + table.file;
      line += ": column '" + column.name + "' holds texts like '" + *found;
      line += "'; --decimal-comma reads them as numbers";
      progress.say(line);
      return;
    }
  }
}

}  // namespace

std::optional<SyntheticLabel> label_of(const table::DataTable& table) {
  const table::DataColumn* const seed = table.find(kSeedColumn);
  if (seed == nullptr || table.rows == 0) {
    return std::nullopt;
  }
  const double value = seed->is_text ? std::nan("") : seed->numbers.front();
  const bool whole = value >= 0.0 && value < 0x1p53 && value == std::floor(value);
  return whole ? SyntheticLabel{static_cast<std::uint64_t>(value)} : SyntheticLabel{};
}

DataFile read_data_file(const std::string& path,
                        std::vector<std::string> wanted,
                        bool decimal_comma,
                        Progress& progress) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw NoInput("no table at '" + path + "'");
  }
  if (!wanted.empty()) {
    wanted.emplace_back(kSeedColumn);
  }
  table::CsvOptions csv;
  csv.decimal_comma = decimal_comma;
  table::DataTableResult read = table::read_data_table(std::filesystem::path(path), wanted, csv);
  progress.say(read.diagnostics);
  if (!read.table) {
    throw BadData("'" + path + "' cannot be used as a table");
  }
  if (!decimal_comma) {
    suggest_decimal_comma(*read.table, progress);
  }
  DataFile file;
  file.path = path;
  file.synthetic = label_of(*read.table);
  file.table = std::move(*read.table);
  return file;
}

Manifest manifest_of(std::string command, const DataFile& file, WrittenOptions written) {
  Manifest manifest;
  manifest.command = std::move(command);
  record(std::move(written), manifest);
  manifest.synthetic = file.synthetic;
  manifest.inputs = {{name_of(file.path), digest_file(file.path)}};
  return manifest;
}

void require_table(const FitReport& report, const std::string& table) {
  if (table.empty() || report.find(table) != nullptr) {
    return;
  }
  std::string known;
  for (const std::string& name : report.table_names()) {
    known += (known.empty() ? "" : ", ") + name;
  }
  throw UsageError("--table: found '" + table + "', expected one of " + known);
}

std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  std::size_t begin = 0;
  while (begin <= list.size()) {
    const std::size_t comma = std::min(list.find(',', begin), list.size());
    if (comma > begin) {
      words.push_back(list.substr(begin, comma - begin));
    }
    begin = comma + 1;
  }
  return words;
}

std::vector<double> numbers_of(const std::string& option, const std::string& list) {
  std::vector<double> numbers;
  for (const std::string& word : words_of(list)) {
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, value);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(value)) {
      std::string problem = "--" + option + ": found '";
      problem += word;
      problem += "', expected numbers, comma between";
      throw UsageError(problem);
    }
    numbers.push_back(value);
  }
  return numbers;
}

}  // namespace tcert::cli
