#pragma once
/// \file
/// Lines of a robot that measures: CSV x,y,value[,plan], or JSON of the same names.

#include <optional>
#include <string>
#include <string_view>

namespace tcert {

struct MeasurementLine {
  int x = 0;  ///< The cell.
  int y = 0;
  double value = 0.0;
  bool plan = true;  ///< False: measured beside the way, and no answer is wanted.
};

/// What a line is. Neither a measurement nor a problem: a header, a comment, an empty line.
struct MeasurementReading {
  std::optional<MeasurementLine> measurement;
  std::string problem;     ///< "found ..., expected ..."; or empty.
  bool is_header = false;  ///< Which may stand before the first measurement alone.
};

/// "230,220,1359.4", "230,220,1359.4,0", {"x": 230, "y": 220, "value": 1359.4, "plan": false}, of
/// which all but plan is needed. A CSV line of which no cell is a number is a header.
[[nodiscard]] MeasurementReading read_measurement(std::string_view line);

}  // namespace tcert
