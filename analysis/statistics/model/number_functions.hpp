#pragma once
/// \file
/// The functions and operators of formulas that take numbers, by name. Internal to variable.cpp.

#include <string_view>

namespace tcert::statistics {

/// log, log2, log10, log1p, exp, sqrt, sin, cos, tan, abs, I, as.numeric.
struct NumberFunction {
  std::string_view name;
  double (*value)(double);
};

/// + - * / ^ and comparisons, whose values are 0 and 1.
struct NumberOperator {
  std::string_view name;
  double (*value)(double, double);
  bool is_comparison;
};

/// Null if there is none of this name.
[[nodiscard]] const NumberFunction* find_number_function(std::string_view name) noexcept;
[[nodiscard]] const NumberOperator* find_number_operator(std::string_view name) noexcept;

}  // namespace tcert::statistics
