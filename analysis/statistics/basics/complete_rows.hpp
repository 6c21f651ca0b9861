#pragma once
/// \file
/// The rows of a binary outcome on which predictors can be scored together.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

/// Rows where every score, the outcome and, if there are clusters, the cluster are known.
struct CompleteRows {
  std::vector<std::vector<double>> scores;
  std::vector<std::uint8_t> success;
  std::vector<std::uint32_t> cluster;  ///< From 0 to clusters - 1, each with a row; may be empty.
  std::size_t successes = 0;
  std::size_t failures = 0;
  std::size_t missing = 0;
  std::size_t clusters = 0;
  bool clustered = false;
};

/// Leaves out and counts the rows where a score or the outcome is NaN or the cluster is
/// Factor::kMissing. An empty `cluster` means none; its codes are numbered anew, in their order.
/// \throws std::invalid_argument if the lengths differ or an outcome is neither 0, 1 nor NaN.
/// O(rows), O(rows log rows) with clusters.
[[nodiscard]] CompleteRows complete_rows(std::span<const std::span<const double>> scores,
                                         std::span<const double> success,
                                         std::span<const std::uint32_t> cluster = {});

}  // namespace tcert::statistics
