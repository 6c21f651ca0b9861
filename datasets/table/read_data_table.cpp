#include <table/read_data_table.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <table/cell_reading.hpp>
#include <table/decimal.hpp>
#include <table/text_file.hpp>
#include <unordered_map>

namespace tcert::table {
namespace {

/// Cells within the padded bytes may be scanned ahead; those that were quoted lie elsewhere.
class MeaningReader {
 public:
  MeaningReader(std::string_view bytes, char point) : bytes_(bytes), point_(point) {}

  [[nodiscard]] CellReading read(std::string_view cell) const {
    const char* const end = cell.data() + cell.size();
    const bool inside = cell.data() >= bytes_.data() && end <= bytes_.data() + bytes_.size();
    CellReading reading{CellMeaning::number, 0.0};
    if (inside && !cell.empty() && scan_number(cell.data(), point_, reading.value) == end) {
      return reading;
    }
    return read_cell(cell, point_);
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

/// What a column has been seen to hold.
struct Seen {
  bool other_numbers = false;  ///< Neither 0 nor 1.
  bool zero_or_one = false;
  bool truths = false;
  bool texts = false;

  [[nodiscard]] bool is_text() const noexcept { return texts || (truths && other_numbers); }
  [[nodiscard]] bool is_truth() const noexcept { return truths && !zero_or_one && !is_text(); }
};

constexpr std::size_t kSkipped = std::numeric_limits<std::size_t>::max();

struct Reading {
  DataTable table;
  std::vector<std::size_t> slot;  ///< Per column of the file: index into table.columns.
  std::vector<Seen> seen;
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
    reading.table.columns.push_back({name, false, {}, {}, false, {}});
  }
  reading.seen.resize(reading.table.columns.size());
  return reading;
}

void read_numbers(const Bytes& bytes,
                  const CsvHeader& header,
                  Reading& reading,
                  DiagnosticGroups& problems) {
  const MeaningReader reader(bytes.view(), header.dialect.decimal_point);
  auto& columns = reading.table.columns;
  std::vector<double> row(columns.size());
  const auto take = [&](std::size_t position, std::string_view cell) {
    const std::size_t slot = reading.slot[position];
    if (slot == kSkipped) {
      return;
    }
    Seen& seen = reading.seen[slot];
    if (seen.texts) {
      return;  // its numbers are not kept
    }
    const CellReading read = reader.read(cell);
    row[slot] = read.value;
    if (read.meaning == CellMeaning::number) {
      const bool zero_or_one = read.value == 0.0 || read.value == 1.0;
      seen.zero_or_one = seen.zero_or_one || zero_or_one;
      seen.other_numbers = seen.other_numbers || !zero_or_one;
    } else {
      seen.truths = seen.truths || read.meaning == CellMeaning::truth;
      seen.texts = seen.texts || read.meaning == CellMeaning::missing_word ||
                   read.meaning == CellMeaning::text;
    }
  };
  const auto end_row = [&](std::size_t line, std::size_t cells, bool open_quote) {
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
    columns[k].is_text = reading.seen[k].is_text();
    columns[k].is_truth = reading.seen[k].is_truth();
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
      columns[slot].text.codes.push_back(is_missing_cell(cell) ? Factor::kMissing
                                                               : levels[slot].code(cell));
    }
  };
  for_each_cell(header, take, [](std::size_t, std::size_t, bool) {});
  for (std::size_t k = 0; k < columns.size(); ++k) {
    levels[k].finish(columns[k].text);
    if (columns[k].is_text) {
      columns[k].mixed = count_mixed_cells(columns[k].text, header.dialect.decimal_point);
    }
  }
}

void warn_of_mixed_columns(const DataTable& table, DiagnosticGroups& problems) {
  for (const DataColumn& column : table.columns) {
    const MixedCells& mixed = column.mixed;
    const std::size_t others = mixed.missing_words + mixed.texts + mixed.truths;
    if (mixed.is_spoiled() || mixed.numbers > others) {
      const bool numbers = mixed.numbers > 0;
      problems.add(
          {Severity::warning,
           table.file,
           table.lines[mixed.first_row],
           column.name,
           shortened(column.text.levels[column.text.codes[mixed.first_row]]),
           (numbers ? "a number, as in its " + std::to_string(mixed.numbers)
                    : "TRUE or FALSE, as in its " + std::to_string(mixed.truths)) +
               " other cells" +
               (mixed.has_missing_words() ? " (" + std::string(kHowMissingIsWritten) + ")" : "") +
               "; the column is taken as text"});
    }
  }
}

}  // namespace

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
      warn_of_mixed_columns(reading.table, problems);
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
  const BytesResult file = read_text_file(path);
  if (!file.bytes) {
    return {std::nullopt, {{Severity::error, csv.file, 0, "", file.problem, "a readable file", 1}}};
  }
  return read_data_table(*file.bytes, wanted, csv);
}

}  // namespace tcert::table
