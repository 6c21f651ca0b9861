#pragma once
/// \file
/// Tables and model frames in one line, for tests.

#include <filesystem>
#include <statistics/model/model_frame.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <table/read_data_table.hpp>
#include <utility>

namespace tcert::test_support {

[[nodiscard]] inline table::DataTable table_or_throw(table::DataTableResult&& result) {
  if (!result.table) {
    std::string problems = "no table";
    for (const table::Diagnostic& diagnostic : result.diagnostics) {
      problems += "\n" + table::to_string(diagnostic);
    }
    throw std::runtime_error(problems);
  }
  return std::move(*result.table);
}

/// The table of a CSV text; throws std::runtime_error with the diagnostics if it cannot be read.
[[nodiscard]] inline table::DataTable table_of(std::string_view csv) {
  table::CsvOptions options;
  options.file = "test.csv";
  return table_or_throw(table::read_data_table(table::Bytes::copy_of(csv), {}, options));
}

/// The same of a file.
[[nodiscard]] inline table::DataTable table_of_file(const std::filesystem::path& path) {
  return table_or_throw(table::read_data_table(path));
}

/// A formula on a file.
[[nodiscard]] inline statistics::ModelFrame frame_of_file(
    const std::filesystem::path& path,
    const std::string& formula,
    const statistics::FrameOptions& options = {}) {
  return statistics::model_frame(statistics::parse_formula(formula), table_of_file(path), options);
}

}  // namespace tcert::test_support
