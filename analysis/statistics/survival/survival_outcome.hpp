#pragma once
/// \file
/// Times to an event, with censoring and left truncation, as the survival estimators take them.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tcert::statistics {

/// One row each. A row is at risk on (start, stop]; at `stop` it has its event or is censored.
struct SurvivalOutcome {
  std::vector<double> start;        ///< Empty: every row is at risk from the beginning.
  std::vector<double> stop;         ///< Finite.
  std::vector<std::uint8_t> event;  ///< 1 for an event, 0 for censored.

  [[nodiscard]] std::size_t rows() const noexcept { return stop.size(); }
  [[nodiscard]] bool left_truncated() const noexcept { return !start.empty(); }
};

/// The outcome on these rows, in their order.
[[nodiscard]] SurvivalOutcome on_rows(const SurvivalOutcome& outcome,
                                      const std::vector<std::size_t>& rows);

}  // namespace tcert::statistics
