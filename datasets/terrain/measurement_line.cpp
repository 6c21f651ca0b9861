#include "datasets/terrain/measurement_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <table/diagnostic.hpp>
#include <table/trimmed.hpp>
#include <vector>

namespace tcert {
namespace {

constexpr std::string_view kExpected =
    "expected x,y,value or x,y,value,plan with whole x and y and a plan of 0 or 1";
constexpr std::array<std::string_view, 5> kFields{"x", "y", "value", "plan", "synthetic_seed"};
constexpr std::size_t kNeededCells = 3;
constexpr std::size_t kPlan = 3;
constexpr std::size_t kSeed = 4;

[[nodiscard]] MeasurementReading bad(std::string_view line) {
  return {std::nullopt, fmt::format("found '{}', {}", table::shortened(line), kExpected)};
}

[[nodiscard]] std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty()
             ? std::optional(value)
             : std::nullopt;
}

/// Of x, y, value and perhaps plan.
[[nodiscard]] std::optional<MeasurementLine> measurement_of(const std::vector<double>& v) {
  constexpr double kFar = 1e6;
  const auto is_whole = [](double x) { return std::abs(x) < kFar && x == std::floor(x); };
  if (v.size() < kNeededCells || v.size() > kPlan + 1 || !is_whole(v[0]) || !is_whole(v[1]) ||
      !std::isfinite(v[2]) || (v.size() > kPlan && v[kPlan] != 0.0 && v[kPlan] != 1.0)) {
    return std::nullopt;
  }
  return MeasurementLine{
      static_cast<int>(v[0]), static_cast<int>(v[1]), v[2], v.size() <= kPlan || v[kPlan] == 1.0};
}

[[nodiscard]] std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = std::min(line.find(','), line.size());
    std::string_view cell = table::trimmed(line.substr(0, comma));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
      cell = cell.substr(1, cell.size() - 2);
    }
    cells.push_back(cell);
    if (comma == line.size()) {
      return cells;
    }
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

MeasurementReading MeasurementLines::read(std::string_view line) {
  line = table::trimmed(line);
  if (line.empty() || line.front() == '#') {
    return {};
  }
  return line.front() == '{' ? read_json(line) : read_cells(line);
}

MeasurementReading MeasurementLines::read_json(std::string_view line) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  std::vector<double> v;
  for (std::size_t k = 0; k < kNeededCells; ++k) {
    const std::string name(kFields[k]);
    if (!json.is_object() || !json.contains(name) || !json[name].is_number()) {
      return bad(line);
    }
    v.push_back(json[name].get<double>());
  }
  if (json.contains("plan")) {
    v.push_back(json["plan"].is_boolean() ? (json["plan"].get<bool>() ? 1.0 : 0.0) : -1.0);
  }
  return json.size() == v.size() ? taken(measurement_of(v), line) : bad(line);
}

MeasurementReading MeasurementLines::read_header(const std::vector<std::string_view>& names) {
  if (has_begun_) {
    return {std::nullopt, "a header in the midst of measurements"};
  }
  std::array<std::optional<std::size_t>, kFields.size()> columns;
  for (std::size_t k = 0; k < kFields.size(); ++k) {
    const auto at = std::find(names.begin(), names.end(), kFields[k]);
    if (at != names.end()) {
      columns[k] = static_cast<std::size_t>(at - names.begin());
    }
  }
  columns_.reset();
  if (columns[0] && columns[1] && columns[2]) {
    columns_ = columns;
    width_ = names.size();
  }
  return {};
}

MeasurementReading MeasurementLines::read_cells(std::string_view line) {
  const std::vector<std::string_view> cells = cells_of(line);
  if (std::none_of(cells.begin(), cells.end(), [](auto cell) { return number_of(cell); })) {
    return read_header(cells);
  }
  if (columns_ && cells.size() != width_) {
    return bad(line);
  }
  std::vector<double> v;
  for (std::size_t k = 0; k < (columns_ ? kPlan + 1 : cells.size()); ++k) {
    if (columns_ && !(*columns_)[k]) {
      continue;  // There is no column for the plan.
    }
    const auto value = number_of(cells[columns_ ? *(*columns_)[k] : k]);
    if (!value) {
      return bad(line);
    }
    v.push_back(*value);
  }
  MeasurementReading reading = taken(measurement_of(v), line);
  if (reading.measurement && columns_ && (*columns_)[kSeed]) {
    std::uint64_t seed = 0;
    const std::string_view cell = cells[*(*columns_)[kSeed]];
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), seed);
    if (error == std::errc{} && end == cell.data() + cell.size() && !synthetic_seed_) {
      synthetic_seed_ = seed;
    }
  }
  return reading;
}

MeasurementReading MeasurementLines::taken(const std::optional<MeasurementLine>& measurement,
                                           std::string_view line) {
  if (!measurement) {
    return bad(line);
  }
  has_begun_ = true;
  return {measurement, {}};
}

}  // namespace tcert
