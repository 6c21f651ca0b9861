#include "datasets/terrain/esri_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "datasets/terrain/cell_table.hpp"

namespace tcert::terrain_reading {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// Cuts the first word off a line.
[[nodiscard]] std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kBlanks), line.size()));
  const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
  const std::string_view word = line.substr(0, end);
  line.remove_prefix(end);
  return word;
}

struct Header {
  std::optional<double> columns;
  std::optional<double> rows;
  std::optional<double> x;
  std::optional<double> y;
  std::optional<double> centre_x;
  std::optional<double> centre_y;
  std::optional<double> cell;
  std::optional<double> dx;
  std::optional<double> dy;
  std::optional<double> nodata;
};

struct Key {
  std::string_view name;
  std::optional<double> Header::*field;
};
constexpr std::array<Key, 10> kKeys{{{"ncols", &Header::columns},
                                     {"nrows", &Header::rows},
                                     {"xllcorner", &Header::x},
                                     {"xllcenter", &Header::centre_x},
                                     {"yllcorner", &Header::y},
                                     {"yllcenter", &Header::centre_y},
                                     {"cellsize", &Header::cell},
                                     {"dx", &Header::dx},
                                     {"dy", &Header::dy},
                                     {"nodata_value", &Header::nodata}}};

[[nodiscard]] const Key* key_of(std::string_view word) {
  for (const Key& key : kKeys) {
    bool same = key.name.size() == word.size();
    for (std::size_t k = 0; same && k < word.size(); ++k) {
      const char c = word[k];
      same = key.name[k] == (c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c);
    }
    if (same) {
      return &key;
    }
  }
  return nullptr;
}

class EsriReader {
 public:
  EsriReader(std::string_view text, std::string file) : rest_(text), file_(std::move(file)) {}

  EsriGrid read() {
    if (read_header() && read_cells()) {
      grid_.nodata = header_.nodata;
      grid_.note = note();
      set_frame();
    }
    grid_.problems = problems_.take();
    return std::move(grid_);
  }

 private:
  bool fail(std::size_t line, std::string column, std::string_view value, std::string expected) {
    problems_.add({table::Severity::error,
                   file_,
                   line,
                   std::move(column),
                   table::shortened(value),
                   std::move(expected),
                   1});
    return false;
  }

  [[nodiscard]] bool read_header() {
    bool good = true;
    while (!rest_.empty()) {
      std::string_view after = rest_;
      std::string_view line = take_line(after);
      const std::string_view word = take_word(line);
      const Key* const key = key_of(word);
      if (key == nullptr && !word.empty()) {
        break;
      }
      rest_ = after;
      ++number_;
      if (key == nullptr) {
        continue;
      }
      double value = 0.0;
      const std::string_view text = take_word(line);
      // A word for a gap as nodata value says nothing new: such words are gaps anyway.
      if (to_number(text, value)) {
        header_.*key->field = value;
      } else if (key->field != &Header::nodata || !is_gap_word(text)) {
        good = fail(number_, std::string(key->name), text, "a number");
      }
    }
    return good && has_sides();
  }

  [[nodiscard]] bool has_sides() {
    const auto is_side = [](const std::optional<double>& n) {
      return n && *n >= 2.0 && *n <= kMostTerrainSide && *n == std::floor(*n);
    };
    if (!is_side(header_.columns) || !is_side(header_.rows)) {
      const auto said = [](const std::optional<double>& n) {
        return n ? fmt::format("{:g}", *n) : std::string("none");
      };
      return fail(0,
                  "",
                  fmt::format("ncols {}, nrows {}", said(header_.columns), said(header_.rows)),
                  "both in the header of an ESRI ASCII grid, whole numbers from 2 to " +
                      std::to_string(kMostTerrainSide));
    }
    grid_.terrain.columns = static_cast<int>(*header_.columns);
    grid_.terrain.rows = static_cast<int>(*header_.rows);
    if ((header_.cell && !(*header_.cell > 0.0)) || (header_.dx && !(*header_.dx > 0.0)) ||
        (header_.dy && !(*header_.dy > 0.0))) {
      return fail(0, "", "", "a cellsize above 0");
    }
    return true;
  }

  [[nodiscard]] bool read_cells() {
    const std::size_t wanted = static_cast<std::size_t>(grid_.terrain.rows) *
                               static_cast<std::size_t>(grid_.terrain.columns);
    std::size_t found = 0;
    while (!rest_.empty()) {
      std::string_view line = take_line(rest_);
      ++number_;
      std::size_t column = 0;
      for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
        ++column;
        ++found;
        double value = std::numeric_limits<double>::quiet_NaN();
        if (!to_number(word, value) && !is_gap_word(word)) {
          fail(number_,
               bad_columns_.of(column),
               word,
               word.find(',') == std::string_view::npos
                   ? "a finite number in every cell, or a gap: nan or the NODATA_value"
                   : "numbers with a decimal point, not a comma");
        }
        if (found <= wanted) {
          grid_.terrain.values.push_back(value);
        }
      }
    }
    if (found != wanted) {
      return fail(0,
                  "",
                  std::to_string(found) + " values",
                  fmt::format("nrows x ncols of the header, {} x {} = {}",
                              grid_.terrain.rows,
                              grid_.terrain.columns,
                              wanted));
    }
    return !problems_.has_error();
  }

  void set_frame() {
    const std::optional<double> dx = header_.dx ? header_.dx : header_.cell;
    const std::optional<double> dy = header_.dy ? header_.dy : header_.cell;
    if (!dx || !dy) {
      return;
    }
    MapFrame& frame = grid_.terrain.frame;
    frame.rows_run_south = true;
    frame.x_step = *dy;
    frame.y_step = *dx;
    frame.east = header_.centre_x ? *header_.centre_x : header_.x.value_or(0.0) + 0.5 * *dx;
    const double south = header_.centre_y ? *header_.centre_y : header_.y.value_or(0.0) + 0.5 * *dy;
    frame.north = south + (grid_.terrain.rows - 1) * *dy;
    frame.is_declared = true;
  }

  [[nodiscard]] std::string note() const {
    std::string text = fmt::format(
        "ESRI ASCII grid of {} x {} cells: x counts its rows from north to south, y its columns "
        "from west to east",
        grid_.terrain.rows,
        grid_.terrain.columns);
    if (header_.x && header_.y) {
      text +=
          fmt::format("; its south-west corner lies at {:.10g}, {:.10g}", *header_.x, *header_.y);
    } else if (header_.centre_x && header_.centre_y) {
      text += fmt::format("; the centre of its south-west cell lies at {:.10g}, {:.10g}",
                          *header_.centre_x,
                          *header_.centre_y);
    }
    const std::optional<double> dx = header_.dx ? header_.dx : header_.cell;
    const std::optional<double> dy = header_.dy ? header_.dy : header_.cell;
    if (dx && dy && *dx != *dy) {
      text += fmt::format(
          "; a cell is {:.6g} x {:.6g} units, not square, and all lengths are in cells", *dx, *dy);
    } else if (dx && dy) {
      text += fmt::format(
          "; its cellsize is {0:.6g}, but lengths, --lipschitz and length scales stay per "
          "cell "
          "(a slope of s per unit is L = {0:.6g} s) unless --units metres says otherwise",
          *dx);
    }
    return text;
  }

  std::string_view rest_;
  std::string file_;
  Header header_;
  EsriGrid grid_;
  table::DiagnosticGroups problems_;
  NamedColumns bad_columns_;
  std::size_t number_ = 0;
};

}  // namespace

bool is_esri_grid(std::string_view text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    const std::string_view word = take_word(line);
    if (!word.empty()) {
      double value = 0.0;
      const std::string_view next = take_word(line);
      return key_of(word) != nullptr && !next.empty() &&
             (to_number(next, value) || next == "nan") && take_word(line).empty();
    }
  }
  return false;
}

EsriGrid read_esri_grid(std::string_view text, const std::string& file) {
  return EsriReader(text, file).read();
}

}  // namespace tcert::terrain_reading
