#include "datasets/terrain_file.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <table/csv_write.hpp>
#include <table/file_kind.hpp>

#include "datasets/terrain/cell_table.hpp"
#include "datasets/terrain/degrees.hpp"
#include "datasets/terrain/esri_grid.hpp"
#include "datasets/terrain/header_rule.hpp"
#include "datasets/terrain/nodata.hpp"
#include "datasets/terrain/point_list.hpp"

namespace tcert {
namespace {

namespace reading = terrain_reading;

/// Reads one file, and keeps what is wrong with it and how it was understood.
class Reader {
 public:
  explicit Reader(const TerrainFileOptions& options) : options_(options) {}

  TerrainFileResult read(std::string_view bytes) {
    if (const auto kind = table::kind_of_binary(bytes, options_.file)) {
      fail("", table::text_expected(*kind));
      return finish();
    }
    if (bytes.substr(0, 3) == "\xEF\xBB\xBF") {
      bytes.remove_prefix(3);
    }
    const bool esri = options_.format == TerrainFormat::esri ||
                      (options_.format == TerrainFormat::detect && reading::is_esri_grid(bytes));
    if (esri) {
      read_esri(bytes);
    } else {
      read_table(bytes);
    }
    if (!table::has_error(result_.diagnostics)) {
      check_sides();
      if (reading::may_be_in_degrees(terrain_)) {
        note(
            "if the map is in degrees, put it into metres first (gdalwarp -t_srs): a degree is not "
            "as long along both axes, and no metre");
      }
    }
    if (!table::has_error(result_.diagnostics)) {
      mark_gaps();
    }
    return finish();
  }

 private:
  void read_esri(std::string_view bytes) {
    reading::EsriGrid grid = reading::read_esri_grid(bytes, options_.file);
    terrain_ = std::move(grid.terrain);
    nodata_ = grid.nodata;
    note(std::move(grid.note));
    result_.diagnostics = std::move(grid.problems);
  }

  void read_table(std::string_view bytes) {
    reading::CellTable table = reading::read_cells(bytes, options_.file);
    result_.diagnostics = std::move(table.problems);
    if (table::has_error(result_.diagnostics)) {
      return;  // Its lines may be of different lengths.
    }
    reading::HeaderDecision decision = reading::decide_header(table, options_.header);
    if (decision.header && options_.header == TerrainHeader::detect && starts_with_a_point(table)) {
      decision = {};
    }
    terrain_.header = decision.header ? std::string(table.first_text) : table.comment;
    if (!decision.header && table.first_line != 0) {
      put_first_line(table);
    }
    if (table::has_error(result_.diagnostics)) {
      return;
    }
    if (decision.index_column && table.columns > 1) {
      drop_first_column(table);
    }
    const bool named = decision.header && has_coordinate_names(table);
    if (options_.format == TerrainFormat::detect && table.columns > 3 &&
        (named || begins_with_a_lattice(table))) {
      fail(std::to_string(table.columns) + " columns",
           "a rectangle of values, but the first two columns are the coordinates of points: keep "
           "x, y and one value, or, if this is a terrain, give --terrain-format grid");
      return;
    }
    if (options_.format == TerrainFormat::points ||
        (options_.format == TerrainFormat::detect && table.columns == 3)) {
      if (read_points(table, options_.format == TerrainFormat::points || named)) {
        return;
      }
      note(
          "read as a terrain three cells wide; if these are points x, y, value, they form no "
          "lattice: put them on one first (gdal_grid)");
    }
    note(decision.note);
    terrain_.rows = static_cast<int>(table.rows);
    terrain_.columns = static_cast<int>(table.columns);
    terrain_.values = std::move(table.values);
  }

  /// True if these are points, good or not.
  bool read_points(const reading::CellTable& table, bool wanted) {
    if (table.columns != 3) {
      fail(std::to_string(table.columns) + " columns", "three: x, y and value of a point a line");
      return true;
    }
    reading::PointListResult points = reading::read_points(table.values, wanted);
    switch (points.kind) {
      case reading::PointList::none:
        return false;
      case reading::PointList::broken:
        fail("", points.problem);
        return true;
      case reading::PointList::lattice:
        break;
    }
    std::string header = std::move(terrain_.header);
    terrain_ = std::move(points.terrain);
    terrain_.header = std::move(header);
    note(std::move(points.note));
    return true;
  }

  /// 0, 1, 2 may be a point: it is if it and the other lines are a lattice.
  [[nodiscard]] static bool starts_with_a_point(const reading::CellTable& table) {
    std::vector<double> values;
    for (const std::string_view cell : table.first) {
      values.push_back(0.0);
      if (!reading::to_number(cell, values.back())) {
        return false;
      }
    }
    if (table.columns != 3 || values.size() != 3) {
      return false;
    }
    values.insert(values.end(), table.values.begin(), table.values.end());
    return reading::read_points(values, false).kind == reading::PointList::lattice;
  }

  /// The names of the first two columns that are left are those of coordinates.
  [[nodiscard]] static bool has_coordinate_names(const reading::CellTable& table) {
    const std::size_t names = table.first.size();
    return names >= table.columns && table.columns >= 3 &&
           reading::names_coordinates(table.first[names - table.columns],
                                      table.first[names - table.columns + 1]);
  }

  /// Points with more than one value each.
  [[nodiscard]] static bool begins_with_a_lattice(const reading::CellTable& table) {
    constexpr std::size_t kMostValues = 16;
    if (table.columns > kMostValues) {
      return false;
    }
    std::vector<double> points;
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      if (i % table.columns < 3) {
        points.push_back(table.values[i]);
      }
    }
    return reading::read_points(points, false).kind == reading::PointList::lattice;
  }

  /// The first line is data after all.
  void put_first_line(reading::CellTable& table) {
    if (table.first.size() != table.columns) {
      fail(table.first_line,
           "",
           std::to_string(table.first.size()) + " cells",
           "as many cells as in the next row, " + std::to_string(table.columns));
      return;
    }
    std::vector<double> first;
    table::DiagnosticGroups words;
    reading::NamedColumns columns;
    for (std::size_t k = 0; k < table.first.size(); ++k) {
      double value = std::nan("");
      if (!reading::is_gap_word(table.first[k]) && !reading::to_number(table.first[k], value)) {
        words.add({table::Severity::error,
                   options_.file,
                   table.first_line,
                   columns.of(k + 1),
                   table::shortened(table.first[k]),
                   "a finite number in every cell, or a gap: nothing, nan or NA",
                   1});
      }
      first.push_back(value);
    }
    for (table::Diagnostic& word : words.take()) {
      result_.diagnostics.push_back(std::move(word));
    }
    table.values.insert(table.values.begin(), first.begin(), first.end());
    ++table.rows;
  }

  static void drop_first_column(reading::CellTable& table) {
    std::vector<double> kept;
    kept.reserve(table.values.size());
    for (std::size_t i = 0; i < table.values.size(); ++i) {
      if (i % table.columns != 0) {
        kept.push_back(table.values[i]);
      }
    }
    table.values = std::move(kept);
    --table.columns;
  }

  void check_sides() {
    const int least = std::min(terrain_.rows, terrain_.columns);
    const int most = std::max(terrain_.rows, terrain_.columns);
    if (least >= 2 && most <= kMostTerrainSide) {
      return;
    }
    fail(std::to_string(terrain_.rows) + " x " + std::to_string(terrain_.columns),
         least < 2 ? "at least two rows and two columns of numbers"
                   : "at most " + std::to_string(kMostTerrainSide) + " rows and columns");
  }

  void mark_gaps() {
    reading::GapsResult gaps = reading::mark_gaps(terrain_.values, options_.nodata, nodata_);
    for (std::string& one : gaps.notes) {
      note(std::move(one));
    }
    if (!gaps.problem.empty()) {
      fail("", gaps.problem);
    }
  }

  TerrainFileResult finish() {
    if (!table::has_error(result_.diagnostics)) {
      result_.terrain = std::move(terrain_);
    }
    return std::move(result_);
  }

  void note(std::string sentence) {
    if (!sentence.empty()) {
      result_.notes.push_back(std::move(sentence));
    }
  }

  void fail(std::string value, std::string expectation) {
    fail(0, "", std::move(value), std::move(expectation));
  }

  void fail(std::size_t line, std::string column, std::string value, std::string expectation) {
    result_.diagnostics.push_back({table::Severity::error,
                                   options_.file,
                                   line,
                                   std::move(column),
                                   std::move(value),
                                   std::move(expectation),
                                   1});
  }

  const TerrainFileOptions& options_;
  TerrainGrid terrain_;
  std::optional<double> nodata_;
  TerrainFileResult result_;
};

}  // namespace

TerrainFileResult read_terrain(const table::Bytes& bytes, const TerrainFileOptions& options) {
  return Reader(options).read(bytes.view());
}

TerrainFileResult read_terrain(const std::filesystem::path& path, TerrainFileOptions options) {
  if (options.file.empty()) {
    options.file = path.string();
  }
  const table::BytesResult file = table::read_file(path);
  if (!file.bytes) {
    TerrainFileResult result;
    table::Diagnostic problem;
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
    if (std::isnan(terrain.values[i])) {
      text += "nan";
    } else {
      table::append_number(text, terrain.values[i]);
    }
    text += (i + 1) % static_cast<std::size_t>(terrain.columns) == 0 ? '\n' : ',';
  }
  return text;
}

}  // namespace tcert
