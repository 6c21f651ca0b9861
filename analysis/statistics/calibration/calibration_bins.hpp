#pragma once
/// \file
/// Outcomes binned by their predicted probability, and what is made of the bins.

#include <cstdint>
#include <optional>
#include <span>
#include <statistics/calibration/calibration.hpp>
#include <vector>

namespace tcert::statistics {

/// Complete rows of a calibration.
struct CalibrationRows {
  std::vector<double> probability;     ///< In [0, 1].
  std::vector<double> outcome;         ///< 0 or 1.
  std::vector<std::uint32_t> cluster;  ///< Codes; empty without clusters.
};

/// Bins with a trial each, rising. Cuts that tie are one. O(n log n).
[[nodiscard]] std::vector<CalibrationBin> calibration_bins(const CalibrationRows& rows,
                                                           const CalibrationOptions& options);

/// Index of the bin of each row. O(n log bins).
[[nodiscard]] std::vector<std::size_t> bin_of_rows(std::span<const double> probability,
                                                   std::span<const CalibrationBin> bins);

/// \pre there is a row.
[[nodiscard]] BrierParts brier_parts(const CalibrationRows& rows,
                                     std::span<const CalibrationBin> bins);

/// Sum over bins of (observed - expected)^2 / (expected (1 - expected / n)); empty for fewer
/// than 3, and if a bin expects exactly none or all.
[[nodiscard]] std::optional<ChiSquareTest> hosmer_lemeshow(std::span<const CalibrationBin> bins);

}  // namespace tcert::statistics
