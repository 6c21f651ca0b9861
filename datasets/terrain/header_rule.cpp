#include "datasets/terrain/header_rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tcert::terrain_reading {
namespace {

/// A header's coordinates lie so many times further from the first row than that from the second.
constexpr double kFar = 10.0;

struct FirstLine {
  std::vector<double> numbers;  ///< Of all cells that are numbers.
  bool has_word = false;        ///< A cell that is neither a number nor a gap.
  bool corner = false;          ///< The first cell is empty or a word.
};

[[nodiscard]] FirstLine look_at(const std::vector<std::string_view>& cells) {
  FirstLine line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    double value = 0.0;
    if (to_number(cells[k], value)) {
      line.numbers.push_back(value);
    } else {
      const bool word = !is_gap_word(cells[k]);
      line.has_word = line.has_word || word;
      line.corner = line.corner || (k == 0 && (word || cells[k].empty()));
    }
  }
  return line;
}

[[nodiscard]] std::span<const double> row_of(const CellTable& table, std::size_t row) {
  return std::span(table.values).subspan(row * table.columns, table.columns);
}

[[nodiscard]] std::vector<double> first_column(const CellTable& table) {
  std::vector<double> values;
  for (std::size_t row = 0; row < table.rows; ++row) {
    values.push_back(table.values[row * table.columns]);
  }
  return values;
}

/// 0, 1, 2, ... or 1, 2, 3, ...
[[nodiscard]] bool counts(std::span<const double> values) {
  if (values.size() < 2 || (values[0] != 0.0 && values[0] != 1.0)) {
    return false;
  }
  for (std::size_t k = 1; k < values.size(); ++k) {
    if (values[k] != values[k - 1] + 1.0) {
      return false;
    }
  }
  return true;
}

[[nodiscard]] double median_distance(std::span<const double> a, std::span<const double> b) {
  std::vector<double> distances;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
    if (const double d = std::abs(a[k] - b[k]); std::isfinite(d)) {
      distances.push_back(d);
    }
  }
  if (distances.empty()) {
    return 0.0;
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

/// The first line lies far from the second, those two do not lie far from one another.
[[nodiscard]] bool lies_far_off(std::span<const double> first, const CellTable& table) {
  if (table.rows < 2) {
    return false;
  }
  const std::size_t skip = table.columns - std::min(first.size(), table.columns);
  const std::span<const double> next = row_of(table, 0).subspan(skip);
  return median_distance(first, next) >
         kFar * median_distance(next, row_of(table, 1).subspan(skip));
}

[[nodiscard]] std::string shown(std::span<const double> values) {
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(values.size(), 3); ++k) {
    text += fmt::format("{}{:.10g}", k == 0 ? "" : ", ", values[k]);
  }
  return text + (values.size() > 3 ? ", ..." : "");
}

[[nodiscard]] HeaderDecision dropped(const FirstLine& line, bool index_column) {
  return {true,
          index_column,
          fmt::format("the first line ({}) names the columns and is no data{}; --header no reads "
                      "it as data",
                      shown(line.numbers),
                      index_column ? ", and the first column names the rows" : "")};
}

[[nodiscard]] HeaderDecision decide_by_numbers(const CellTable& table, const FirstLine& line) {
  const std::span<const double> numbers(line.numbers);
  // With one line below there is no terrain without the first.
  if (numbers.size() != table.first.size() || table.rows < 2) {
    return {};
  }
  const std::vector<double> column = first_column(table);
  const std::span<const double> rows(column);
  const std::span<const double> next = row_of(table, 0);
  if (numbers.size() + 1 == table.columns) {
    return counts(numbers) || is_evenly_spaced(numbers) ? dropped(line, true) : HeaderDecision{};
  }
  if (is_evenly_spaced(numbers) && !is_evenly_spaced(next)) {
    if (counts(numbers) || lies_far_off(numbers, table)) {
      return dropped(line, false);
    }
    return {false,
            false,
            fmt::format("the first line ({}) is evenly spaced and read as data; if it names the "
                        "columns, give --header yes",
                        shown(numbers))};
  }
  // A number in the corner, coordinates along both edges.
  if (numbers.size() > 3 && is_evenly_spaced(numbers.subspan(1)) && is_evenly_spaced(rows) &&
      !is_evenly_spaced(next.subspan(1)) && lies_far_off(numbers.subspan(1), table)) {
    return dropped(line, true);
  }
  return {};
}

}  // namespace

bool is_evenly_spaced(std::span<const double> values) {
  if (values.size() < 3) {
    return false;
  }
  const double step = (values.back() - values.front()) / static_cast<double>(values.size() - 1);
  constexpr double kOfAStep = 1e-3;
  constexpr double kRounding = 1e-12;
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double slack = kOfAStep * std::abs(step) + kRounding * std::abs(values[k]);
    if (!(std::abs(values[k] - values[k - 1] - step) <= slack)) {
      return false;
    }
  }
  return step != 0.0;
}

HeaderDecision decide_header(const CellTable& table, TerrainHeader mode) {
  if (mode == TerrainHeader::no || table.first_line == 0) {
    return {};
  }
  const FirstLine line = look_at(table.first);
  const std::vector<double> column = table.rows > 0 ? first_column(table) : std::vector<double>{};
  const bool rows_are_named = counts(column) || is_evenly_spaced(column);
  const bool index =
      table.rows > 0 && rows_are_named && (line.corner || table.first.size() + 1 == table.columns);
  if (line.has_word && line.numbers.empty()) {
    HeaderDecision decision{true, index && table.first.front().empty(), {}};
    decision.index_column =
        decision.index_column || (index && table.first.size() + 1 == table.columns);
    // A named column that counts the rows: 0, 1, 2 or 1, 2, 3.
    decision.index_column = decision.index_column || (table.rows > 2 && counts(column));
    if (decision.index_column) {
      decision.note = "the first column names the rows and is no data; --header no reads it";
    }
    return decision;
  }
  if (line.corner && line.numbers.size() + 1 == table.first.size() &&
      (index || is_evenly_spaced(line.numbers) || counts(line.numbers))) {
    return dropped(line, index);
  }
  HeaderDecision decision = decide_by_numbers(table, line);
  if (mode == TerrainHeader::yes) {
    decision.header = true;
    decision.note = decision.index_column ? "the first column names the rows and is no data" : "";
  }
  return decision;
}

}  // namespace tcert::terrain_reading
