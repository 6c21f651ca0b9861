#include "datasets/terrain/cell_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <table/cell_reading.hpp>
#include <table/decimal.hpp>
#include <table/not_a_number.hpp>
#include <utility>

#include "datasets/terrain_file.hpp"

namespace tcert::terrain_reading {
namespace {

[[nodiscard]] bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

/// Cells of a line; runs of blanks count as one separator where the separator is a blank.
class Line {
 public:
  Line(std::string_view text, char separator)
      : at_(text.data()), end_(text.data() + text.size()), separator_(separator) {}

  /// The next cell without outer blanks; false at the end of the line.
  bool next(std::string_view& cell) {
    if (done_) {
      return false;
    }
    if (separator_ == ' ') {
      skip_blanks();
      if (at_ == end_) {
        return false;
      }
    }
    const char* from = at_;
    while (at_ != end_ && !separates(*at_)) {
      ++at_;
    }
    const char* to = at_;
    done_ = at_ == end_;
    if (!done_) {
      ++at_;
    }
    while (from != to && is_blank(*from)) {
      ++from;
    }
    while (from != to && is_blank(to[-1])) {
      --to;
    }
    if (to - from >= 2 && *from == '"' && to[-1] == '"') {
      ++from;
      --to;
    }
    cell = {from, static_cast<std::size_t>(to - from)};
    return true;
  }

 private:
  [[nodiscard]] bool separates(char c) const noexcept {
    return separator_ == ' ' ? is_blank(c) : c == separator_;
  }
  void skip_blanks() noexcept {
    while (at_ != end_ && is_blank(*at_)) {
      ++at_;
    }
  }

  const char* at_;
  const char* end_;
  char separator_;
  bool done_ = false;
};

/// A semicolon goes first: where there is one, commas are decimal.
[[nodiscard]] char separator_of(std::string_view line) {
  for (const char candidate : {';', ',', '\t'}) {
    if (line.find(candidate) != std::string_view::npos) {
      return candidate;
    }
  }
  return ' ';
}

[[nodiscard]] std::vector<std::string_view> cells_of(std::string_view text, char separator) {
  std::vector<std::string_view> cells;
  Line line(text, separator);
  for (std::string_view cell; line.next(cell);) {
    cells.emplace_back(cell);
  }
  return cells;
}

[[nodiscard]] bool has_number(const std::vector<std::string_view>& cells) {
  double value = 0.0;
  return std::any_of(
      cells.begin(), cells.end(), [&](std::string_view cell) { return to_number(cell, value); });
}

class CellTableReader {
 public:
  explicit CellTableReader(std::string file) : file_(std::move(file)) {}

  void line(std::string_view text, std::size_t number) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos || full_) {
      return;
    }
    if (text[begin] == '#') {
      if (table_.comment.empty()) {
        table_.comment = text;
      }
      return;
    }
    if (table_.first_line == 0) {
      separator_ = separator_of(text);
      table_.first = cells_of(text, separator_);
      table_.first_text = text;
      table_.first_line = number;
      return;
    }
    if (table_.rows == 0 && !has_number(table_.first)) {
      // A title may hold commas where the numbers have blanks.
      separator_ = separator_of(text);
      table_.first = cells_of(table_.first_text, separator_);
    }
    row(text, number);
  }

  CellTable finish() {
    if (table_.rows == 0) {
      table_.columns = table_.first.size();
    }
    if (table_.rows > 0 && ends_in_nothing_ == table_.rows && table_.columns > 2) {
      drop_last_column();
    }
    table_.problems = problems_.take();
    return std::move(table_);
  }

 private:
  void row(std::string_view text, std::size_t number) {
    Line cells(text, separator_);
    std::size_t columns = 0;
    std::string_view cell;
    while (cells.next(cell)) {
      ++columns;
      if (table_.values.size() >= kMostTerrainCells) {
        report(number, "", "", "at most " + std::to_string(kMostTerrainCells) + " cells");
        full_ = true;
        return;
      }
      double value = table::kNaN;
      if (!to_number(cell, value)) {
        if (is_gap_word(cell)) {
          ++table_.words;
        } else {
          report(number,
                 bad_columns_.of(columns),
                 table::shortened(cell),
                 cell.find(',') == std::string_view::npos
                     ? "a finite number in every cell, or a gap: nothing, nan or NA"
                     : "numbers with a decimal point, not a comma");
        }
      }
      table_.values.push_back(value);
    }
    ends_in_nothing_ += cell.empty() ? 1U : 0U;
    if (table_.rows == 0) {
      table_.columns = expected_columns(columns);
    }
    if (columns != table_.columns) {
      report(number,
             "",
             std::to_string(columns) + " cells",
             "as many cells as in the first row, " + std::to_string(table_.columns));
    }
    ++table_.rows;
  }

  /// A title has as many cells as it likes, and one that names columns may lack the first, that of
  /// the rows' names.
  [[nodiscard]] std::size_t expected_columns(std::size_t columns) const {
    const std::size_t first = table_.first.size();
    return columns == first + 1 || !has_number(table_.first) ? columns : first;
  }

  void drop_last_column() {
    std::vector<double> kept;
    kept.reserve(table_.values.size());
    for (std::size_t i = 0; i < table_.values.size(); ++i) {
      if ((i + 1) % table_.columns != 0) {
        kept.push_back(table_.values[i]);
      }
    }
    table_.words -= table_.rows;
    table_.values = std::move(kept);
    --table_.columns;
    if (table_.first.size() > table_.columns && table_.first.back().empty()) {
      table_.first.pop_back();
    }
  }

  void report(std::size_t line, std::string column, std::string value, std::string expectation) {
    problems_.add({table::Severity::error,
                   file_,
                   line,
                   std::move(column),
                   std::move(value),
                   std::move(expectation),
                   1});
  }

  std::string file_;
  CellTable table_;
  table::DiagnosticGroups problems_;
  NamedColumns bad_columns_;
  std::size_t ends_in_nothing_ = 0;
  char separator_ = ',';
  bool full_ = false;
};

}  // namespace

std::string NamedColumns::of(std::size_t column) {
  constexpr std::size_t kMostNamed = 3;
  if (std::find(named_.begin(), named_.end(), column) == named_.end()) {
    if (named_.size() == kMostNamed) {
      return {};
    }
    named_.push_back(column);
  }
  return std::to_string(column);
}

bool to_number(std::string_view cell, double& value) {
  double number = 0.0;
  if (cell.empty() || table::scan_number(cell.data(), '.', number) != cell.data() + cell.size()) {
    const table::CellReading reading = table::read_cell(cell);
    if (reading.meaning != table::CellMeaning::number || !std::isfinite(reading.value)) {
      return false;
    }
    number = reading.value;
  }
  value = number;
  return true;
}

bool is_gap_word(std::string_view cell) {
  const table::CellReading reading = table::read_cell(cell);
  switch (reading.meaning) {
    case table::CellMeaning::missing:
    case table::CellMeaning::missing_word:
      return true;
    case table::CellMeaning::number:
      return !std::isfinite(reading.value);
    case table::CellMeaning::truth:
      return false;
    case table::CellMeaning::text:
      break;
  }
  std::string lower(cell);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
  });
  constexpr std::array<std::string_view, 3> kWords{"nodata", "no_data", "--"};
  return std::find(kWords.begin(), kWords.end(), lower) != kWords.end();
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
  return line;
}

CellTable read_cells(std::string_view text, const std::string& file) {
  CellTableReader reader(file);
  for (std::size_t number = 1; !text.empty(); ++number) {
    reader.line(take_line(text), number);
  }
  return reader.finish();
}

}  // namespace tcert::terrain_reading
