#include "datasets/terrain_file.hpp"

#include <cmath>
#include <string_view>

#include "datasets/cell_reading.hpp"
#include "datasets/csv_write.hpp"
#include "datasets/decimal.hpp"

namespace tcert {
namespace {

constexpr std::size_t kMostCells = std::size_t{1} << 26U;

[[nodiscard]] bool is_blank(char c) noexcept { return c == ' ' || c == '\t'; }

/// Cells of a line; runs of blanks count as one separator where the separator is a blank.
class Line {
 public:
  Line(const char* begin, const char* end, char separator)
      : at_(begin), end_(end), separator_(separator) {}

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

[[nodiscard]] bool to_number(std::string_view cell, double& value) {
  if (!cell.empty() && scan_number(cell.data(), '.', value) == cell.data() + cell.size()) {
    return true;
  }
  const CellReading reading = read_cell(cell);
  value = reading.value;
  return reading.meaning == CellMeaning::number && std::isfinite(value);
}

[[nodiscard]] char separator_of(std::string_view line) {
  for (const char candidate : {',', ';', '\t'}) {
    if (line.find(candidate) != std::string_view::npos) {
      return candidate;
    }
  }
  return ' ';
}

/// Reads line by line and keeps what is wrong.
class Reader {
 public:
  explicit Reader(const TerrainFileOptions& options) : options_(options) {}

  void line(std::string_view text) {
    ++number_;
    if (!text.empty() && text.back() == '\r') {
      text.remove_suffix(1);
    }
    if (text.find_first_not_of(" \t") == std::string_view::npos) {
      return;
    }
    if (!seen_) {
      separator_ = separator_of(text);
    }
    const bool first = !seen_;
    seen_ = true;
    if (first && is_header(text)) {
      terrain_.header = text;
      return;
    }
    row(text);
  }

  TerrainFileResult finish() {
    if (terrain_.rows < 2 || terrain_.columns < 2) {
      report(0,
             "",
             std::to_string(terrain_.rows) + " x " + std::to_string(terrain_.columns),
             "at least two rows and two columns of numbers");
    }
    TerrainFileResult result;
    if (!problems_.has_error()) {
      result.terrain = std::move(terrain_);
    }
    result.diagnostics = problems_.take();
    return result;
  }

 private:
  [[nodiscard]] bool is_header(std::string_view text) const {
    if (options_.header != TerrainHeader::detect) {
      return options_.header == TerrainHeader::yes;
    }
    Line cells(text.data(), text.data() + text.size(), separator_);
    std::string_view cell;
    double value = 0.0;
    while (cells.next(cell)) {
      if (to_number(cell, value) || is_no_name(cell)) {
        return false;
      }
    }
    return true;
  }

  /// Words for an infinity or a missing cell are data, not names.
  [[nodiscard]] static bool is_no_name(std::string_view cell) {
    const CellMeaning meaning = read_cell(cell).meaning;
    return meaning == CellMeaning::number || meaning == CellMeaning::missing ||
           meaning == CellMeaning::missing_word;
  }

  void row(std::string_view text) {
    Line cells(text.data(), text.data() + text.size(), separator_);
    std::string_view cell;
    int columns = 0;
    while (cells.next(cell)) {
      ++columns;
      if (terrain_.values.size() >= kMostCells) {
        if (!full_) {
          report(number_, "", "", "at most 67108864 cells");
        }
        full_ = true;
        return;
      }
      double value = 0.0;
      if (!to_number(cell, value)) {
        report(number_,
               std::to_string(columns),
               shortened(cell),
               "a finite number in every cell; fill gaps before exploring");
      }
      terrain_.values.push_back(value);
    }
    if (terrain_.rows == 0) {
      terrain_.columns = columns;
    } else if (columns != terrain_.columns) {
      report(number_,
             "",
             std::to_string(columns) + " cells",
             "as many cells as in the first row, " + std::to_string(terrain_.columns));
    }
    ++terrain_.rows;
  }

  void report(std::size_t line, std::string column, std::string value, std::string expectation) {
    Diagnostic problem;
    problem.file = options_.file;
    problem.line = line;
    problem.column = std::move(column);
    problem.value = std::move(value);
    problem.expectation = std::move(expectation);
    problems_.add(std::move(problem));
  }

  TerrainFileOptions options_;
  TerrainGrid terrain_;
  DiagnosticGroups problems_;
  std::size_t number_ = 0;
  char separator_ = ',';
  bool seen_ = false;
  bool full_ = false;
};

}  // namespace

TerrainFileResult read_terrain(const Bytes& bytes, const TerrainFileOptions& options) {
  Reader reader(options);
  std::string_view rest = bytes.view();
  if (rest.substr(0, 3) == "\xEF\xBB\xBF") {
    rest.remove_prefix(3);
  }
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    reader.line(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return reader.finish();
}

TerrainFileResult read_terrain(const std::filesystem::path& path, TerrainFileOptions options) {
  if (options.file.empty()) {
    options.file = path.string();
  }
  const BytesResult file = read_file(path);
  if (!file.bytes) {
    TerrainFileResult result;
    Diagnostic problem;
    problem.file = options.file;
    problem.expectation = "a readable file: " + file.problem;
    result.diagnostics.push_back(problem);
    return result;
  }
  return read_terrain(*file.bytes, options);
}

std::string terrain_text(const TerrainGrid& terrain) {
  std::string text = terrain.header.empty() ? "" : terrain.header + '\n';
  for (std::size_t i = 0; i < terrain.values.size(); ++i) {
    append_number(text, terrain.values[i]);
    text += (i + 1) % static_cast<std::size_t>(terrain.columns) == 0 ? '\n' : ',';
  }
  return text;
}

}  // namespace tcert
