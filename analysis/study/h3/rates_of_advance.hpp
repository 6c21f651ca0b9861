#pragma once
/// \file
/// The statistic that H3 bootstraps: rates of advance of both algorithms, and what gating gains.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::study {

/// The trials of a group that succeed, as arrays that the bootstrap runs over.
struct Advance {
  std::vector<std::uint8_t> baseline;
  std::vector<std::size_t> lighting;  ///< Below `lightings`.
  std::size_t lightings = 0;
  std::vector<double> length;
  std::vector<double> time;
  std::vector<std::vector<double>> gated_time;  ///< [case][trial]
};

// Values of the statistic: five of the group, then four a case.
enum GroupValue : std::size_t {
  value_ungated,
  value_baseline,
  value_standardised,
  value_gap,
  value_gap_as_run,
  group_values
};
enum CaseValue : std::size_t {
  value_gated,
  value_gain,
  value_gain_share,
  value_recovered,
  case_values
};

/// Fills `values`, group_values + case_values a case, from trials that occur `multiplicity` times;
/// NaN where there is no rate. O(trials cases).
void rates(const Advance& advance,
           std::span<const std::uint32_t> multiplicity,
           std::span<double> values);

}  // namespace tcert::study
