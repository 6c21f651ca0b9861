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

[[nodiscard]] std::string found(std::string_view line) {
  return fmt::format("found '{}', {}", table::shortened(line), kExpected);
}

using table::trimmed;

[[nodiscard]] std::optional<double> number_of(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty()
             ? std::optional(value)
             : std::nullopt;
}

[[nodiscard]] std::optional<MeasurementLine> measurement_of(const std::vector<double>& v) {
  constexpr double kFar = 1e6;
  const auto is_whole = [](double x) { return std::abs(x) < kFar && x == std::floor(x); };
  if (v.size() < 3 || v.size() > 4 || !is_whole(v[0]) || !is_whole(v[1]) || !std::isfinite(v[2]) ||
      (v.size() == 4 && v[3] != 0.0 && v[3] != 1.0)) {
    return std::nullopt;
  }
  return MeasurementLine{
      static_cast<int>(v[0]), static_cast<int>(v[1]), v[2], v.size() < 4 || v[3] == 1.0};
}

[[nodiscard]] MeasurementReading read_json(std::string_view line) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  std::vector<double> v;
  for (const char* const name : {"x", "y", "value"}) {
    if (!json.is_object() || !json.contains(name) || !json[name].is_number()) {
      return {std::nullopt, found(line)};
    }
    v.push_back(json[name].get<double>());
  }
  if (json.contains("plan")) {
    v.push_back(json["plan"].is_boolean() ? (json["plan"].get<bool>() ? 1.0 : 0.0) : -1.0);
  }
  const auto measurement = json.size() == v.size() ? measurement_of(v) : std::nullopt;
  return {measurement, measurement ? std::string() : found(line)};
}

}  // namespace

MeasurementReading read_measurement(std::string_view line) {
  line = trimmed(line);
  if (line.empty() || line.front() == '#') {
    return {};
  }
  if (line.front() == '{') {
    return read_json(line);
  }
  std::vector<double> v;
  std::size_t cells = 0;
  for (std::string_view rest = line;; ++cells) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    if (const auto value = number_of(trimmed(rest.substr(0, comma)))) {
      v.push_back(*value);
    }
    if (comma == rest.size()) {
      ++cells;
      break;
    }
    rest.remove_prefix(comma + 1);
  }
  if (v.empty()) {
    return {std::nullopt, {}, true};
  }
  const auto measurement = v.size() == cells ? measurement_of(v) : std::nullopt;
  return {measurement, measurement ? std::string() : found(line)};
}

}  // namespace tcert
