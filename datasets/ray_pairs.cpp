#include "datasets/ray_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <table/cell_reading.hpp>
#include <table/rename_advice.hpp>
#include <utility>

#include "datasets/measured_cells.hpp"
#include "datasets/ray_pair_units.hpp"

namespace tcert {
namespace {

/// Names in a column, and which of them each row that is used has.
struct NamedRows {
  std::vector<std::string> names;
  std::vector<std::uint32_t> of_row;
};

class PairReader {
 public:
  PairReader(const table::TextTable& rows,
             const std::string& file,
             table::DiagnosticGroups& problems)
      : rows_(rows), file_(file), problems_(problems), cells_(rows, file, problems) {}

  RayPairs read() {
    RayPairs result;
    const std::size_t bend_column = rows_.find("bend_rad").value();
    const std::size_t clearance_column = rows_.find("clearance_m").value();
    std::vector<std::size_t> used;
    for (std::size_t row = 0; row < rows_.rows(); ++row) {
      const std::optional<double> bend = cells_.number(row, bend_column);
      const std::optional<double> clearance = cells_.number(row, clearance_column);
      if (!bend || !clearance) {
        continue;
      }
      units_.look_at(*bend,
                     *clearance,
                     rows_.lines[row],
                     rows_.at(row, bend_column),
                     rows_.at(row, clearance_column));
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
    const SyntheticTable made = synthetic_table(rows_);
    result.synthetic = made.synthetic;
    result.seed = made.seed;
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
        cells_.report(table::Severity::error, rows_.lines[row], name, cell, "a name");
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

  void say(const RayPairs& result) {
    units_.say(file_, problems_);
    if (result.missing > 0) {
      cells_.report(table::Severity::note,
                    0,
                    "",
                    std::to_string(result.missing) + " rows without a bend or a clearance",
                    "both in each; they are left out");
    }
    if (result.pairs.empty()) {
      cells_.report(table::Severity::error, 0, "", "no pair", "rows with a bend and a clearance");
    }
  }

  const table::TextTable& rows_;
  const std::string& file_;
  table::DiagnosticGroups& problems_;
  MeasuredCells cells_;
  RayPairUnits units_;
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
  table::drop_rename_advice(result.diagnostics);
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
