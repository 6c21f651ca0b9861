#pragma once
/// \file
/// Lines of a robot that measures: CSV x,y,value[,plan], or JSON of the same names.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

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
  std::string problem;  ///< "found ..., expected ..."; or empty.
};

/// Reads one line after the other: "230,220,1359.4", "230,220,1359.4,0",
/// {"x": 230, "y": 220, "value": 1359.4, "plan": false}, of which all but plan is needed. A CSV
/// line of which no cell is a number is a header, which stands before the first measurement alone.
/// If it names x, y and value its columns are found by name, and others are not looked at: so it
/// reads the measurements.csv of a run.
class MeasurementLines {
 public:
  [[nodiscard]] MeasurementReading read(std::string_view line);

  /// What the first cell of a column synthetic_seed that holds a number says.
  [[nodiscard]] const std::optional<std::uint64_t>& synthetic_seed() const noexcept {
    return synthetic_seed_;
  }

 private:
  [[nodiscard]] MeasurementReading read_cells(std::string_view line);
  [[nodiscard]] MeasurementReading read_json(std::string_view line);
  [[nodiscard]] MeasurementReading read_header(const std::vector<std::string_view>& names);
  [[nodiscard]] MeasurementReading taken(const std::optional<MeasurementLine>& measurement,
                                         std::string_view line);

  /// Where a header that names them has x, y, value, plan and synthetic_seed.
  std::optional<std::array<std::optional<std::size_t>, 5>> columns_;
  std::size_t width_ = 0;  // of that header
  bool has_begun_ = false;
  std::optional<std::uint64_t> synthetic_seed_;
};

}  // namespace tcert
