#pragma once
/// \file
/// Reads a CSV file as typed columns.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <table/bytes.hpp>
#include <table/csv_header.hpp>
#include <table/data_table.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

struct DataTableResult {
  std::optional<DataTable> table;  ///< Empty iff there is an error.
  std::vector<Diagnostic> diagnostics;
};

/// Reads the columns called `wanted`, all of them if it is empty; names that the file does not have
/// are not an error here. Cells are read by read_cell(). A row with another number of cells than
/// the header is an error; a text column that holds more numbers than texts, or is spoiled, a
/// warning. O(size).
[[nodiscard]] DataTableResult read_data_table(const std::filesystem::path& path,
                                              std::span<const std::string> wanted = {},
                                              CsvOptions csv = {});

/// The same from bytes; `csv.file` names them.
[[nodiscard]] DataTableResult read_data_table(const Bytes& bytes,
                                              std::span<const std::string> wanted,
                                              const CsvOptions& csv);

}  // namespace tcert::table
