#pragma once
/// \file
/// What the numbers of a range ray's column say: a clearance, nothing within reach, or nothing at
/// all.

#include <cstddef>
#include <limits>
#include <span>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert {

/// What bundle.json declares of a range ray beside its place. Nothing, by default.
struct RangeKeys {
  std::vector<double> no_return;  ///< Values that mean "nothing within reach", beside inf.
  double range_min_m = 0.0;       ///< Readings below it are missing.
  double range_max_m = std::numeric_limits<double>::infinity();  ///< Readings above it likewise.
};

/// How often a ray's readings were what.
struct RangeCount {
  std::size_t stated = 0;      ///< Cells with a value, infinite ones too.
  std::size_t negative = 0;    ///< Finite and below 0, and not declared: missing.
  std::size_t below_min = 0;   ///< Missing.
  std::size_t above_max = 0;   ///< Missing.
  std::size_t undeclared = 0;  ///< All others that are finite and no declared no_return.
  std::size_t zero = 0;        ///< Of the undeclared ones.
  double lowest = std::numeric_limits<double>::infinity();          ///< Of the negative ones.
  double highest = -std::numeric_limits<double>::infinity();        ///< Of the undeclared ones.
  double below_highest = -std::numeric_limits<double>::infinity();  ///< The next lower one.
  std::size_t at_highest = 0;

  /// True if a reading that was stated is missing.
  [[nodiscard]] bool has_missing() const noexcept { return negative + below_min + above_max > 0; }
};

/// True if `value` is one of those that mean "nothing within reach", to 1e-6 of itself: logs keep
/// single precision.
[[nodiscard]] bool is_no_return(std::span<const double> declared, double value) noexcept;

/// The rule of every ray of a robot, for logs, ticks and live lines alike:
///
/// - of kind range, in this order: +inf and a declared no_return (within 1e-6 of itself: logs keep
///   single precision) are the reach; -inf, nearer than the sensor can tell, is 0; below 0, below
///   range_min_m and above range_max_m is missing; everything else stays as it is.
/// - of kind bend: as it is.
///
/// Missing stays missing. No rule rejects a reading.
class RangeRules {
 public:
  /// `keys` may be shorter than the robot has rays: of those beyond nothing is declared.
  RangeRules(const Robot& robot, std::span<const RangeKeys> keys);

  /// What `value`, as stated in a log, says of ray `ray`. \pre ray < rays().
  [[nodiscard]] double resolve(std::size_t ray, double value) const noexcept;

  /// The same, counted.
  double resolve(std::size_t ray, double value, RangeCount& count) const noexcept;

  /// What to write for a reading of ray `ray` so that resolve() gives it again: -inf for a 0 and
  /// inf for the reach where the number itself is declared to mean something else.
  [[nodiscard]] double stated(std::size_t ray, double reading) const noexcept;

  [[nodiscard]] std::size_t rays() const noexcept { return rays_.size(); }
  [[nodiscard]] bool is_range(std::size_t ray) const noexcept { return rays_[ray].is_range; }

 private:
  struct RayRule {
    bool is_range = false;
    double reach_m = 0.0;
    RangeKeys keys;
  };
  std::vector<RayRule> rays_;
};

}  // namespace tcert
