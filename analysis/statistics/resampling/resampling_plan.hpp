#pragma once
/// \file
/// What a bootstrap draws: rows or whole clusters, within strata if there are any.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

/// The units of a table and the draws of every replicate. A unit is a row or a cluster and lies in
/// one stratum; a replicate draws as many units from each stratum as it has, with replacement.
class ResamplingPlan {
 public:
  /// Every row a unit. `strata` holds one code a row; empty for a single stratum.
  /// \throws std::invalid_argument if there is no row, the lengths differ or a code is missing.
  [[nodiscard]] static ResamplingPlan of_rows(std::size_t rows,
                                              std::span<const std::uint32_t> strata = {});

  /// Every cluster a unit, in the order of the codes. \throws std::invalid_argument as `of_rows`,
  /// and if a cluster lies in two strata.
  [[nodiscard]] static ResamplingPlan of_clusters(std::span<const std::uint32_t> cluster,
                                                  std::span<const std::uint32_t> strata = {});

  [[nodiscard]] std::size_t rows() const noexcept { return unit_of_row_.size(); }
  [[nodiscard]] std::size_t units() const noexcept { return stratum_of_unit_.size(); }
  [[nodiscard]] std::size_t strata() const noexcept { return stratum_start_.size() - 1; }
  [[nodiscard]] std::uint32_t unit_of(std::size_t row) const noexcept { return unit_of_row_[row]; }
  [[nodiscard]] std::uint32_t stratum_of(std::size_t unit) const noexcept {
    return stratum_of_unit_[unit];
  }
  /// Units in the stratum of `unit`.
  [[nodiscard]] std::size_t stratum_size(std::size_t unit) const noexcept {
    const std::uint32_t s = stratum_of_unit_[unit];
    return stratum_start_[s + 1] - stratum_start_[s];
  }

  /// How often each row is in replicate `replicate`: draws stratum by stratum, the k-th of them
  /// RandomStream(seed, analysis, replicate).below(units of the stratum): unbiased (Lemire 2019,
  /// with rejection), the same for any number of threads. `unit_scratch` has units() values,
  /// `multiplicity` rows() values. O(rows + units), no allocation.
  void draw(std::uint64_t seed,
            std::uint32_t analysis,
            std::uint64_t replicate,
            std::span<std::uint32_t> unit_scratch,
            std::span<std::uint32_t> multiplicity) const noexcept;

 private:
  ResamplingPlan(std::vector<std::uint32_t> unit_of_row,
                 std::size_t units,
                 std::span<const std::uint32_t> strata);

  bool units_are_rows_ = false;
  std::vector<std::uint32_t> unit_of_row_;
  std::vector<std::uint32_t> stratum_of_unit_;
  std::vector<std::size_t> stratum_start_;  // Into stratum_units_, and its end.
  std::vector<std::uint32_t> stratum_units_;
};

}  // namespace tcert::statistics
