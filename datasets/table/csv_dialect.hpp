#pragma once
/// \file
/// How a CSV file separates its fields, and reading one field of any dialect.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::table {

/// In order of preference where a file fits several: a separator that is rare in plain text first.
inline constexpr std::array<char, 5> kCsvSeparators{'\t', ';', '|', ',', ' '};

/// A separator of ' ' stands for any run of spaces and tabs, those at the line's ends included.
struct CsvDialect {
  char separator = ',';
  char decimal_point = '.';
};

/// A place in a text, with its 1-based line.
struct CsvCursor {
  const char* at = nullptr;
  const char* end = nullptr;
  std::size_t line = 1;
};

/// Start of the text: after a byte-order mark, if there is one.
[[nodiscard]] CsvCursor csv_begin(std::string_view text) noexcept;

/// Skips blank lines and lines that begin with '#'; false at the end of the text.
[[nodiscard]] bool skip_to_record(CsvCursor& cursor) noexcept;

struct CsvField {
  std::string_view text;  ///< Without quotes and outer spaces; valid until the next call.
  bool ends_record = false;
  bool open_quote = false;  ///< A quote that is never closed: the text goes to the end.
};

/// Reads the field at the cursor and moves past its separator or line end. A field that begins with
/// a quote may hold separators, line ends and doubled quotes; `unquoted` keeps the text of such a
/// one.
[[nodiscard]] CsvField scan_field(CsvCursor& cursor, char separator, std::string& unquoted);

/// Reads the record at the cursor into `fields`, re-using their memory; false if a quote is open.
bool scan_record(CsvCursor& cursor, char separator, std::vector<std::string>& fields);

/// Name of a separator for messages: "comma", "semicolon", "tab", "vertical bar", "spaces".
[[nodiscard]] std::string_view separator_name(char separator) noexcept;

/// The separator that gives most of the first records one common number of fields, at least two;
/// ',' if none does. With a `decimal_point` of ',' it is not the comma if any other does.
[[nodiscard]] char detect_separator(std::string_view text, char decimal_point = '.');

}  // namespace tcert::table
