// Any bytes as a CSV file: the reader neither throws nor reads outside, says why it rejects, and
// the fast and the careful way through a row agree.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <table/csv.hpp>
#include <table/csv_write.hpp>

#include "datasets/stream_clock.hpp"
#include "fuzz/check.hpp"

namespace tcert {
namespace {

using fuzz::require;

table::NumberOptions wanted(bool repair) {
  table::NumberOptions options;
  options.columns = {{"x_m"}, {"left_fsr_n", false, true}};
  options.repair = repair;
  return options;
}

std::string written(const table::NumberTable& table) {
  std::string text = "time_s,x_m,left_fsr_n\n";
  for (std::size_t row = 0; row < table.rows(); ++row) {
    table::append_seconds(text, table.time_ns[row]);
    text += ',';
    table::append_number(text, table.at(row, 0));
    text += ',';
    table::append_number(text, table.at(row, 1));
    text += '\n';
  }
  return text;
}

/// All cells in quotes, which only the careful way reads.
std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text.substr(0, text.size() - 1)) {
    out += c == ',' ? "\",\"" : c == '\n' ? "\"\n\"" : std::string(1, c);
  }
  return out + "\"\n";
}

void read(std::string_view text, bool repair, bool decimal_comma) {
  table::CsvOptions csv;
  csv.decimal_comma = decimal_comma;
  table::DiagnosticGroups problems;
  auto table = table::read_numbers(table::Bytes::copy_of(text), csv, wanted(repair), problems);
  require(table.has_value() != problems.has_error(), "a file is rejected iff there is an error");
  if (!table) {
    return;
  }
  require(table->rows() > 0, "an accepted file has rows");
  const std::string first = written(*table);
  for (const std::string& again : {first, in_quotes(first)}) {
    table::DiagnosticGroups none;
    const auto copy = table::read_numbers(table::Bytes::copy_of(again), {}, wanted(false), none);
    require(copy.has_value(), "what was read is accepted when written");
    require(written(*copy) == first, "what was read reads back the same");
  }
  static_cast<void>(put_in_order(
      *table, 1.0, {"a.csv", "time_s", true, EqualTimes::in_file_order}, problems));
  static_cast<void>(find_breaks(*table, "a.csv", "time_s", {1.0, 1.0}, problems));
}

}  // namespace
}  // namespace tcert

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read(text, false, false);
  read(text, true, false);
  read(text, true, true);
  table::DiagnosticGroups problems;
  static_cast<void>(
      table::read_text_table(table::Bytes::copy_of(text), {}, {"trial_id"}, problems));
  if (const auto header = table::guess_header(text, {}, problems)) {
    static_cast<void>(table::read_text_rows(table::Bytes::copy_of(text), *header, {}, problems));
  }
  for (const table::Diagnostic& diagnostic : problems.take()) {
    fuzz::require(table::to_string(diagnostic).find('\n') == std::string::npos,
                  "a message is one line");
  }
  return 0;
}
