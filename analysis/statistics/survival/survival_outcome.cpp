#include <statistics/survival/survival_outcome.hpp>

namespace tcert::statistics {

SurvivalOutcome on_rows(const SurvivalOutcome& outcome, const std::vector<std::size_t>& rows) {
  SurvivalOutcome chosen;
  for (const std::size_t row : rows) {
    chosen.stop.push_back(outcome.stop[row]);
    chosen.event.push_back(outcome.event[row]);
    if (outcome.left_truncated()) {
      chosen.start.push_back(outcome.start[row]);
    }
  }
  return chosen;
}

}  // namespace tcert::statistics
