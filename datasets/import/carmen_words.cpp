#include "datasets/import/carmen_words.hpp"

#include <algorithm>
#include <cmath>
#include <table/cell_reading.hpp>
#include <table/decimal.hpp>
#include <table/diagnostic.hpp>
#include <tcert/tick.hpp>
#include <utility>

namespace tcert {

std::string_view take_word(std::string_view& line) noexcept {
  constexpr std::string_view kBlank = " \t\r";
  const std::size_t first = line.find_first_not_of(kBlank);
  if (first == std::string_view::npos) {
    line = {};
    return line;
  }
  line.remove_prefix(first);
  const std::size_t length = std::min(line.find_first_of(kBlank), line.size());
  const std::string_view word = line.substr(0, length);
  line.remove_prefix(length);
  return word;
}

std::string_view CarmenWords::text() noexcept {
  if (!fault_) {
    word_ = take_word(rest_);
  }
  return word_;
}

void CarmenWords::number(const char* field, double& value) {
  if (fault_) {
    return;
  }
  text();
  require(scanned(value), field, "a finite number");
}

std::size_t CarmenWords::count(const char* field, double least, const char* expectation) {
  double value = 0.0;
  number(
      field,
      value,
      [least](double v) {
        return v >= least && v <= static_cast<double>(kMostCarmenBeams) && v == std::floor(v);
      },
      expectation);
  return fault_ ? 0 : static_cast<std::size_t>(value);
}

void CarmenWords::range(double& value) {
  if (fault_) {
    return;
  }
  text();
  if (scanned(value)) {
    require(value >= 0.0, "range", "a range in metres, 0 or more");
    return;
  }
  const table::CellReading reading = table::read_cell(word_);
  const bool is_missing = !word_.empty() && reading.meaning == table::CellMeaning::missing;
  require(is_missing || reading.meaning == table::CellMeaning::number, "range", "a finite number");
  value = is_missing ? kMissing : std::max(reading.value, 0.0);
}

void CarmenWords::pose(const char* x, const char* y, const char* theta, Pose& pose) {
  constexpr const char* kExpected = "a number, at most 1e9 in size";
  const auto holds = [](double v) { return std::abs(v) <= kLargestPose; };
  number(x, pose.position.x_m, holds, kExpected);
  number(y, pose.position.y_m, holds, kExpected);
  number(theta, pose.yaw_rad, holds, kExpected);
}

void CarmenWords::require(bool holds,
                          const char* field,
                          const char* expectation,
                          std::string value) {
  if (!fault_ && !holds) {
    fault_ =
        CarmenFault{field, value.empty() ? table::shortened(word_) : std::move(value), expectation};
  }
}

bool CarmenWords::scanned(double& value) const noexcept {
  return !word_.empty() &&
         table::scan_number(word_.data(), '.', value) == word_.data() + word_.size();
}

}  // namespace tcert
