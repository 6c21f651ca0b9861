#pragma once
/// \file
/// The incidence curves of one group. Internal to cumulative_incidence.cpp.

#include <cstdint>
#include <span>
#include <statistics/survival/cumulative_incidence.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

/// The rows of the group, by their stops and (with late entry) their starts.
struct IncidenceRows {
  const SurvivalOutcome* outcome = nullptr;
  const std::vector<std::uint32_t>* cause = nullptr;
  const IncidenceOptions* options = nullptr;
  std::span<const std::uint32_t> stops;
  std::span<const std::uint32_t> starts;

  [[nodiscard]] double weight(std::uint32_t row) const {
    return options->weights.empty() ? 1.0 : options->weights[row];
  }
  [[nodiscard]] std::uint32_t cluster(std::uint32_t row) const {
    return options->cluster == nullptr ? row : options->cluster->codes[row];
  }
};

/// \pre `curves` has its causes, and nothing in them. O(rows causes), given the orders.
void walk_incidence(const IncidenceRows& rows, IncidenceCurves& curves);

}  // namespace tcert::statistics
