#include "datasets/empty_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace tcert {
namespace {

bool says_something(const TactileStream& stream, std::size_t sample) noexcept {
  const auto readings = std::span(stream.readings).subspan(sample * stream.rays, stream.rays);
  return std::ranges::any_of(readings, [](const RayReading& reading) {
    return !std::isnan(reading.value) || !std::isnan(reading.fsr_n);
  });
}

}  // namespace

void drop_empty_rows(table::NumberTable& table, std::size_t columns) {
  std::size_t kept = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto values = std::span(table.values).subspan(row * table.columns, table.columns);
    if (std::ranges::all_of(values.first(columns),
                            [](double value) { return std::isnan(value); })) {
      ++table.empty_rows;
      continue;
    }
    table.time_ns[kept] = table.time_ns[row];
    table.lines[kept] = table.lines[row];
    std::ranges::copy(values,
                      table.values.begin() + static_cast<std::ptrdiff_t>(kept * table.columns));
    ++kept;
  }
  table.time_ns.resize(kept);
  table.lines.resize(kept);
  table.values.resize(kept * table.columns);
}

std::optional<TactileStream> without_empty_samples(const TactileStream& stream) {
  std::size_t sample = 0;
  while (sample < stream.time_ns.size() && says_something(stream, sample)) {
    ++sample;
  }
  if (sample == stream.time_ns.size() || stream.rays == 0) {
    return std::nullopt;
  }
  TactileStream kept;
  kept.rays = stream.rays;
  const bool arrives = !stream.arrival_ns.empty();
  for (sample = 0; sample < stream.time_ns.size(); ++sample) {
    if (says_something(stream, sample)) {
      const auto first = stream.readings.begin() + static_cast<std::ptrdiff_t>(sample * kept.rays);
      kept.time_ns.push_back(stream.time_ns[sample]);
      if (arrives) {
        kept.arrival_ns.push_back(stream.arrival_ns[sample]);
      }
      kept.readings.insert(
          kept.readings.end(), first, first + static_cast<std::ptrdiff_t>(kept.rays));
    }
  }
  return kept;
}

}  // namespace tcert
