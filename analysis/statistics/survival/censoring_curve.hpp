#pragma once
/// \file
/// The Kaplan-Meier curve of being censored, by whose inverse rows are weighted.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

/// G as steps. Events come before censorings at the same time, as in `survival::finegray` and
/// `prodlim` with `reverse = TRUE`.
class CensoringCurve {
 public:
  /// Of these rows alone; `censored` is 1 where a row is. O(rows log rows).
  CensoringCurve(std::span<const double> stop,
                 std::span<const std::uint8_t> censored,
                 std::vector<std::size_t> rows);

  /// G(t-): censorings before t.
  [[nodiscard]] double before(double t) const noexcept;
  /// G(t): censorings at t too.
  [[nodiscard]] double at(double t) const noexcept;

 private:
  std::vector<double> time_;   // Of censorings, rising.
  std::vector<double> value_;  // G just after each.
};

}  // namespace tcert::statistics
