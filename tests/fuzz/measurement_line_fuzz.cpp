// Any bytes as lines of a robot that measures: what is taken is finite and of whole cells, and what
// is not is a header, a comment, or has a reason.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "datasets/terrain/measurement_line.hpp"
#include "fuzz/check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  MeasurementLines lines;
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const MeasurementReading reading = lines.read(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    fuzz::require(!(reading.measurement && !reading.problem.empty()), "a measurement or a problem");
    if (reading.measurement) {
      fuzz::require(std::isfinite(reading.measurement->value), "a finite value");
      fuzz::require(std::abs(reading.measurement->x) <= 1000000 &&
                        std::abs(reading.measurement->y) <= 1000000,
                    "cells within bounds");
    }
  }
  return 0;
}
