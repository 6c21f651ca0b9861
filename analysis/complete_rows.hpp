#pragma once
/// \file
/// The rows of a binary outcome on which predictors can be scored together.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace tcert {

/// Rows where every score and the outcome are known.
struct CompleteRows {
  std::vector<std::vector<double>> scores;
  std::vector<std::uint8_t> success;
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::size_t missing = 0;
};

/// Leaves out and counts the rows where a score or the outcome is NaN.
/// \throws std::invalid_argument if the lengths differ or an outcome is neither 0, 1 nor NaN.
[[nodiscard]] CompleteRows complete_rows(std::initializer_list<std::span<const double>> scores,
                                         std::span<const double> success);

}  // namespace tcert
