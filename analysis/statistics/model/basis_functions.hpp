#pragma once
/// \file
/// Columns of natural cubic splines and of powers, as R's ns() and poly() have them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tcert::statistics {

/// `splines::ns` without intercept: cubic between the boundary knots, the range of `known`, and
/// linear beyond. `text` names the call in errors.
class NaturalSpline {
 public:
  /// `knots` within, or quantiles for `df` columns, 1 without either. \throws FormulaError without
  /// two known numbers that differ, or for knots that do not lie within them.
  NaturalSpline(const std::vector<double>& known,
                const std::optional<std::int64_t>& df,
                std::vector<double> knots,
                const std::string& text);

  /// [column][row]; NaN where x is. O(rows (knots + 4)^2).
  [[nodiscard]] std::vector<std::vector<double>> columns(const std::vector<double>& x) const;

 private:
  std::vector<double> knots_;  // With the boundaries, four times each.
  double low_ = 0.0;
  double high_ = 0.0;
  std::vector<std::vector<double>>
      reflections_;  // That leave what is linear beyond the boundaries.
};

/// poly(x, degree): orthonormal on `known`, by the three-term recurrence. \throws FormulaError
/// unless `known` has more different numbers than `degree`.
[[nodiscard]] std::vector<std::vector<double>> orthogonal_powers(const std::vector<double>& known,
                                                                 const std::vector<double>& x,
                                                                 std::int64_t degree,
                                                                 const std::string& text);

/// poly(x, degree, raw = TRUE).
[[nodiscard]] std::vector<std::vector<double>> powers(const std::vector<double>& x,
                                                      std::int64_t degree,
                                                      const std::string& text);

}  // namespace tcert::statistics
