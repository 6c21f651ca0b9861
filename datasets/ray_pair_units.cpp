#include "datasets/ray_pair_units.hpp"

#include <cmath>

namespace tcert {
namespace {

constexpr double kLargestBendRadians = 3.2;       // a little more than half a turn
constexpr double kLongestClearanceMetres = 10.0;  // of a tentacle, by far
constexpr std::size_t kMostOddShare = 5;          // one in so many

}  // namespace

RayPairUnits::RayPairUnits()
    : bend_{"bend_rad", "bends in radians, -3.2 to 3.2: degrees?", true, 0, 0, {}},
      clearance_{"clearance_m", "clearances in metres, at most 10: millimetres?", true, 0, 0, {}},
      negative_{
          "clearance_m", "clearances of 0 or more; a negative one counts as 0", false, 0, 0, {}} {}

void RayPairUnits::Odd::add(std::size_t at, const std::string& cell) {
  if (count++ == 0) {
    line = at;
    value = table::shortened(cell);
  }
}

void RayPairUnits::look_at(double bend_rad,
                           double clearance_m,
                           std::size_t line,
                           const std::string& bend,
                           const std::string& clearance) {
  ++pairs_;
  if (std::abs(bend_rad) > kLargestBendRadians) {
    bend_.add(line, bend);
  }
  if (clearance_m > kLongestClearanceMetres) {
    clearance_.add(line, clearance);
  }
  if (clearance_m < 0.0) {
    negative_.add(line, clearance);
  }
}

void RayPairUnits::say(const std::string& file, table::DiagnosticGroups& problems) const {
  for (const Odd& odd : {bend_, clearance_, negative_}) {
    if (odd.count > 0) {
      const bool most = odd.is_unit && kMostOddShare * odd.count > pairs_;
      problems.add({most ? table::Severity::error : table::Severity::warning,
                    file,
                    odd.line,
                    odd.column,
                    odd.value,
                    odd.expectation,
                    odd.count});
    }
  }
}

}  // namespace tcert
