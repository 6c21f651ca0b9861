#include "datasets/data_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "datasets/decimal.hpp"

namespace tcert {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool is_missing(std::string_view cell) noexcept {
  return cell.empty() || cell == "NA" || cell == "NaN" || cell == "nan";
}

bool is_truth_value(std::string_view cell) noexcept {
  return cell == "TRUE" || cell == "true" || cell == "FALSE" || cell == "false";
}

/// The words that stand for a number; false for any other.
bool word_value(std::string_view cell, double& value) noexcept {
  if (is_missing(cell)) {
    value = kNaN;
  } else if (cell == "Inf" || cell == "inf") {
    value = kInfinity;
  } else if (cell == "-Inf" || cell == "-inf") {
    value = -kInfinity;
  } else if (cell == "TRUE" || cell == "true") {
    value = 1.0;
  } else if (cell == "FALSE" || cell == "false") {
    value = 0.0;
  } else {
    return false;
  }
  return true;
}

/// Cells within the padded bytes may be scanned ahead; those that were quoted lie elsewhere.
class CellReader {
 public:
  CellReader(std::string_view bytes, char point) : bytes_(bytes), point_(point) {}

  [[nodiscard]] bool number(std::string_view cell, double& value) const {
    const char* const end = cell.data() + cell.size();
    const bool inside = cell.data() >= bytes_.data() && end <= bytes_.data() + bytes_.size();
    if (inside && !cell.empty()) {
      return scan_number(cell.data(), point_, value) == end || word_value(cell, value);
    }
    std::string text(cell);
    std::replace(text.begin(), text.end(), point_, '.');
    const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [stop, error] = std::from_chars(begin, text.data() + text.size(), value);
    return (error == std::errc{} && stop == text.data() + text.size() && std::isfinite(value)) ||
           word_value(cell, value);
  }

 private:
  std::string_view bytes_;
  char point_;
};

/// Calls `take(position in the file, cell)` for each cell and `end_row(line, cells, open quote)`.
template <class Take, class EndRow>
void for_each_cell(const CsvHeader& header, Take&& take, EndRow&& end_row) {
  CsvCursor cursor = header.data;
  std::string unquoted;
  while (skip_to_record(cursor)) {
    const std::size_t line = cursor.line;
    std::size_t cells = 0;
    CsvField field;
    do {
      field = scan_field(cursor, header.dialect.separator, unquoted);
      if (cells < header.names.size()) {
        take(cells, field.text);
        ++cells;
      } else if (!field.text.empty()) {
        ++cells;
      }
    } while (!field.ends_record);
    end_row(line, cells, field.open_quote);
  }
}

/// Where and why a column stopped being one of numbers.
struct FirstText {
  std::size_t line = 0;
  std::string cell;
  std::size_t texts = 0;
  std::size_t numbers = 0;
  std::size_t truths = 0;  ///< Of the numbers.
};

constexpr std::size_t kSkipped = std::numeric_limits<std::size_t>::max();

struct Reading {
  DataTable table;
  std::vector<std::size_t> slot;  ///< Per column of the file: index into table.columns.
  std::vector<FirstText> first_text;
};

Reading reading_of(const CsvHeader& header,
                   std::span<const std::string> wanted,
                   const CsvOptions& csv) {
  Reading reading;
  reading.table.file = csv.file;
  reading.table.header = header.names;
  for (const std::string& name : header.names) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) {
      reading.slot.push_back(kSkipped);
      continue;
    }
    reading.slot.push_back(reading.table.columns.size());
    reading.table.columns.push_back({name, false, {}, {}, false});
  }
  reading.first_text.resize(reading.table.columns.size());
  return reading;
}

void read_numbers(const Bytes& bytes,
                  const CsvHeader& header,
                  Reading& reading,
                  DiagnosticGroups& problems) {
  const CellReader reader(bytes.view(), header.dialect.decimal_point);
  auto& columns = reading.table.columns;
  std::vector<double> row(columns.size());
  std::vector<std::string> texts(columns.size());
  const auto take = [&](std::size_t position, std::string_view cell) {
    const std::size_t slot = reading.slot[position];
    if (slot == kSkipped) {
      return;
    }
    FirstText& text = reading.first_text[slot];
    if (reader.number(cell, row[slot])) {
      text.numbers += std::isnan(row[slot]) ? 0 : 1;
      text.truths += (row[slot] == 0.0 || row[slot] == 1.0) && is_truth_value(cell) ? 1 : 0;
    } else {
      if (text.texts++ == 0) {
        text.cell = cell;
        text.line = 0;
      }
      columns[slot].is_text = true;
    }
  };
  const auto end_row = [&](std::size_t line, std::size_t cells, bool open_quote) {
    for (FirstText& text : reading.first_text) {
      text.line = text.texts > 0 && text.line == 0 ? line : text.line;
    }
    if (open_quote || cells != header.names.size()) {
      problems.add({Severity::error,
                    reading.table.file,
                    line,
                    "",
                    open_quote ? "a quote that is never closed" : std::to_string(cells) + " fields",
                    std::to_string(header.names.size()) + " fields, as the header has"});
      return;
    }
    for (std::size_t k = 0; k < row.size(); ++k) {
      columns[k].numbers.push_back(row[k]);
    }
    reading.table.lines.push_back(line);
    ++reading.table.rows;
  };
  for_each_cell(header, take, end_row);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const FirstText& text = reading.first_text[k];
    columns[k].is_truth = text.texts == 0 && text.truths > 0 && text.truths == text.numbers;
  }
}

/// Codes in order of appearance; sorted at the end.
class Levels {
 public:
  std::uint32_t code(std::string_view cell) {
    if (cell == last_) {
      return last_code_;
    }
    last_ = cell;
    const auto [entry, is_new] =
        codes_.try_emplace(last_, static_cast<std::uint32_t>(codes_.size()));
    if (is_new) {
      names_.push_back(last_);
    }
    last_code_ = entry->second;
    return last_code_;
  }

  void finish(Factor& factor) {
    std::vector<std::uint32_t> order(names_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return names_[a] < names_[b];
    });
    std::vector<std::uint32_t> rank(names_.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
      rank[order[i]] = i;
      factor.levels.push_back(names_[order[i]]);
    }
    for (std::uint32_t& code : factor.codes) {
      code = code == Factor::kMissing ? code : rank[code];
    }
  }

 private:
  std::unordered_map<std::string, std::uint32_t> codes_;
  std::vector<std::string> names_;
  std::string last_;
  std::uint32_t last_code_ = Factor::kMissing;
};

void read_texts(const CsvHeader& header, Reading& reading) {
  auto& columns = reading.table.columns;
  std::vector<Levels> levels(columns.size());
  for (DataColumn& column : columns) {
    if (column.is_text) {
      column.numbers = {};
      column.text.codes.reserve(reading.table.rows);
    }
  }
  const auto take = [&](std::size_t position, std::string_view cell) {
    const std::size_t slot = reading.slot[position];
    if (slot != kSkipped && columns[slot].is_text) {
      columns[slot].text.codes.push_back(is_missing(cell) ? Factor::kMissing
                                                          : levels[slot].code(cell));
    }
  };
  for_each_cell(header, take, [](std::size_t, std::size_t, bool) {});
  for (std::size_t k = 0; k < columns.size(); ++k) {
    levels[k].finish(columns[k].text);
  }
}

void warn_of_mixed_columns(const Reading& reading, DiagnosticGroups& problems) {
  for (std::size_t k = 0; k < reading.first_text.size(); ++k) {
    const FirstText& text = reading.first_text[k];
    if (text.texts > 0 && text.numbers > text.texts) {
      problems.add({Severity::warning,
                    reading.table.file,
                    text.line,
                    reading.table.columns[k].name,
                    shortened(text.cell),
                    "a number, as in its " + std::to_string(text.numbers) +
                        " other cells; the column is taken as text"});
    }
  }
}

}  // namespace

const DataColumn* DataTable::find(std::string_view name) const noexcept {
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const DataColumn& column) {
    return column.name == name;
  });
  return found == columns.end() ? nullptr : &*found;
}

DataTableResult read_data_table(const Bytes& bytes,
                                std::span<const std::string> wanted,
                                const CsvOptions& csv) {
  DataTableResult result;
  DiagnosticGroups problems;
  if (const auto header = guess_header(bytes.view(), csv, problems)) {
    Reading reading = reading_of(*header, wanted, csv);
    read_numbers(bytes, *header, reading, problems);
    if (!problems.has_error()) {
      if (std::any_of(reading.table.columns.begin(),
                      reading.table.columns.end(),
                      [](const DataColumn& column) { return column.is_text; })) {
        read_texts(*header, reading);
      }
      warn_of_mixed_columns(reading, problems);
      result.table = std::move(reading.table);
    }
  }
  result.diagnostics = problems.take();
  return result;
}

DataTableResult read_data_table(const std::filesystem::path& path,
                                std::span<const std::string> wanted,
                                CsvOptions csv) {
  if (csv.file.empty()) {
    csv.file = path.string();
  }
  const BytesResult file = read_file(path);
  if (!file.bytes) {
    return {std::nullopt, {{Severity::error, csv.file, 0, "", file.problem, "a readable file", 1}}};
  }
  return read_data_table(*file.bytes, wanted, csv);
}

}  // namespace tcert
