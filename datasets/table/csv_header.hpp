#pragma once
/// \file
/// Finding the header line of a CSV file, whatever stands before it, and its columns by name.

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <table/csv_dialect.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

/// How to read a CSV file; the same for numbers and for text.
struct CsvOptions {
  std::string file;                           ///< Its name in diagnostics.
  std::optional<char> separator;              ///< Of kCsvSeparators; found out if empty.
  bool decimal_comma = false;                 ///< Takes effect unless the separator is the comma.
  std::map<std::string, std::string> rename;  ///< Column name in the file -> name to use.
  std::size_t preamble_records = 20;          ///< How many lines may stand before the header.
  bool fold_names =
      false;  ///< Names that are equal when case is folded are refused, as in a bundle.
};

struct CsvHeader {
  CsvDialect dialect;
  std::vector<std::string> names;  ///< After renaming.
  std::size_t line = 0;
  std::size_t preamble_records = 0;  ///< Records before the header, not used.
  CsvCursor data;                    ///< Where the first row begins.

  /// Index of the column of that name.
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;
};

/// The first record that holds all of the `required` columns, or else most of them. Missing
/// columns, equal names, and a file without any record are errors, and then there is no header;
/// records before the header are a note.
[[nodiscard]] std::optional<CsvHeader> find_header(std::string_view text,
                                                   const CsvOptions& options,
                                                   std::span<const std::string> required,
                                                   DiagnosticGroups& problems);

/// The header of a file of which nothing is known. A record is a header if a text of it stands over
/// a column of numbers, and no number of it does (whole numbers that rise may: they number
/// columns); in a file without numbers, if its texts differ. It may have fewer names than the rows
/// have fields if what is left over is empty. Without one, the last line of a comment before the
/// first row is if it has a name for each field (TUM, EuRoC); else the columns are called c1, c2,
/// ... and the header's line is 0. Equal names are an error, and so are rows of another length than
/// the header.
[[nodiscard]] std::optional<CsvHeader> guess_header(std::string_view text,
                                                    const CsvOptions& options,
                                                    DiagnosticGroups& problems);

}  // namespace tcert::table
