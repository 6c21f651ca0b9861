#include "datasets/ray_pairs.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <table/cell_reading.hpp>
#include <utility>

namespace tcert {
namespace {

constexpr double kLargestBendRadians = 3.2;       // a little more than half a turn
constexpr double kLongestClearanceMetres = 10.0;  // of a tentacle, by far
constexpr std::size_t kMostOddShare = 5;          // one in so many

/// Names in a column, and which of them each row that is used has.
struct NamedRows {
  std::vector<std::string> names;
  std::vector<std::uint32_t> of_row;
};

/// Values that cannot be in the unit of their column.
struct OddValues {
  const char* column;
  const char* unit_words;
  double limit;
  std::size_t count = 0;
  std::size_t line = 0;
  std::string value;
};

class PairReader {
 public:
  PairReader(const table::TextTable& rows,
             const std::string& file,
             table::DiagnosticGroups& problems)
      : rows_(rows), file_(file), problems_(problems) {}

  RayPairs read() {
    RayPairs result;
    const std::size_t bend_column = rows_.find("bend_rad").value();
    const std::size_t clearance_column = rows_.find("clearance_m").value();
    std::vector<std::size_t> used;
    for (std::size_t row = 0; row < rows_.rows(); ++row) {
      const std::optional<double> bend = number(row, bend_column);
      const std::optional<double> clearance = number(row, clearance_column);
      if (!bend || !clearance) {
        continue;
      }
      look_at(bend_, row, bend_column, std::abs(*bend));
      look_at(clearance_, row, clearance_column, *clearance);
      look_at(negative_, row, clearance_column, -*clearance);
      used.push_back(row);
      result.pairs.push_back({0, 0, *bend, std::max(*clearance, 0.0)});
    }
    result.missing = rows_.rows() - used.size();
    const NamedRows ray = names_of("ray", used);
    const NamedRows day = names_of("day", used);
    const NamedRows run = names_of("run", used);
    std::set<std::pair<std::uint32_t, std::uint32_t>> runs;
    for (std::size_t i = 0; i < used.size(); ++i) {
      result.pairs[i].ray = ray.of_row[i];
      result.pairs[i].day = day.of_row[i];
      runs.emplace(day.of_row[i], run.of_row[i]);
    }
    result.rays = ray.names;
    result.days = day.names;
    result.runs = runs.size();
    label(result);
    say(result);
    return result;
  }

 private:
  NamedRows names_of(const char* name, const std::vector<std::size_t>& used) {
    const std::size_t column = rows_.find(name).value();
    std::map<std::string, std::uint32_t> codes;
    for (const std::size_t row : used) {
      const std::string& cell = rows_.at(row, column);
      if (table::is_missing_cell(cell)) {
        add(table::Severity::error, rows_.lines[row], name, cell, "a name");
      }
      codes.emplace(cell, 0U);
    }
    NamedRows result;
    for (auto& [text, code] : codes) {
      code = static_cast<std::uint32_t>(result.names.size());
      result.names.push_back(text);
    }
    for (const std::size_t row : used) {
      result.of_row.push_back(codes.at(rows_.at(row, column)));
    }
    return result;
  }

  void label(RayPairs& result) const {
    const auto column = rows_.find("synthetic_seed");
    result.synthetic = column.has_value() && rows_.rows() > 0;
    if (result.synthetic) {
      const std::string& cell = rows_.at(0, *column);
      std::uint64_t seed = 0;
      const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), seed);
      if (error == std::errc{} && stop == cell.data() + cell.size()) {
        result.seed = seed;
      }
    }
  }

  std::optional<double> number(std::size_t row, std::size_t column) {
    const std::string& cell = rows_.at(row, column);
    const table::CellReading reading = table::read_cell(cell, rows_.dialect.decimal_point);
    if (reading.meaning == table::CellMeaning::number && std::isfinite(reading.value)) {
      return reading.value;
    }
    if (reading.meaning != table::CellMeaning::missing) {
      add(table::Severity::error,
          rows_.lines[row],
          rows_.columns[column],
          table::shortened(cell),
          "a finite number (" + std::string(table::kHowMissingIsWritten) + ")");
    }
    return std::nullopt;
  }

  void look_at(OddValues& odd, std::size_t row, std::size_t column, double size) {
    if (size > odd.limit && odd.count++ == 0) {
      odd.line = rows_.lines[row];
      odd.value = table::shortened(rows_.at(row, column));
    }
  }

  void say(const RayPairs& result) {
    for (const OddValues& odd : {bend_, clearance_, negative_}) {
      if (odd.count == 0) {
        continue;
      }
      const bool most = kMostOddShare * odd.count > result.pairs.size() && odd.limit > 0.0;
      add(most ? table::Severity::error : table::Severity::warning,
          odd.line,
          odd.column,
          odd.value,
          odd.unit_words,
          odd.count);
    }
    if (result.missing > 0) {
      add(table::Severity::note,
          0,
          "",
          std::to_string(result.missing) + " rows without a bend or a clearance",
          "both in each; they are left out");
    }
    if (result.pairs.empty()) {
      add(table::Severity::error, 0, "", "no pair", "rows with a bend and a clearance");
    }
  }

  void add(table::Severity severity,
           std::size_t line,
           std::string column,
           std::string value,
           std::string expectation,
           std::size_t count = 1) {
    problems_.add({severity,
                   file_,
                   line,
                   std::move(column),
                   std::move(value),
                   std::move(expectation),
                   count});
  }

  const table::TextTable& rows_;
  const std::string& file_;
  table::DiagnosticGroups& problems_;
  OddValues bend_{
      "bend_rad", "bends in radians, -3.2 to 3.2: degrees?", kLargestBendRadians, 0, 0, {}};
  OddValues clearance_{"clearance_m",
                       "clearances in metres, at most 10: millimetres?",
                       kLongestClearanceMetres,
                       0,
                       0,
                       {}};
  OddValues negative_{
      "clearance_m", "clearances of 0 or more; a negative one counts as 0", 0.0, 0, 0, {}};
};

}  // namespace

RayPairsResult read_ray_pairs(const table::Bytes& bytes, const table::CsvOptions& csv) {
  table::DiagnosticGroups problems;
  const std::optional<table::TextTable> rows = table::read_text_table(
      bytes, csv, {"ray", "run", "day", "bend_rad", "clearance_m"}, problems);
  RayPairsResult result;
  if (rows) {
    result.pairs = PairReader(*rows, csv.file, problems).read();
  }
  if (problems.has_error()) {
    result.pairs.reset();
  }
  result.diagnostics = problems.take();
  for (table::Diagnostic& one : result.diagnostics) {
    // There is no bundle.json to rename columns in.
    one.expectation.resize(std::min(one.expectation.find("; rename"), one.expectation.size()));
  }
  return result;
}

RayPairsResult read_ray_pairs(const std::filesystem::path& path, table::CsvOptions csv) {
  if (csv.file.empty()) {
    csv.file = path.string();
  }
  const table::BytesResult file = table::read_file(path);
  if (!file.bytes) {
    return {std::nullopt,
            {{table::Severity::error, csv.file, 0, "", file.problem, "a readable file", 1}}};
  }
  return read_ray_pairs(*file.bytes, csv);
}

}  // namespace tcert
