#include <statistics/survival/failures_at_limit.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tcert::statistics {

SurvivalOutcome failures_at_limit(const SurvivalOutcome& outcome,
                                  std::span<const std::uint8_t> failure,
                                  double limit) {
  if (failure.size() != outcome.rows() || outcome.event.size() != outcome.rows()) {
    throw std::invalid_argument("failures at limit: columns of different length");
  }
  if (!std::isfinite(limit)) {
    throw std::invalid_argument("failures at limit: the limit must be finite");
  }
  SurvivalOutcome result = outcome;
  for (std::size_t row = 0; row < failure.size(); ++row) {
    if (failure[row] > 1 || (failure[row] == 1 && outcome.event[row] != 0)) {
      throw std::invalid_argument("failures at limit: a failed row has an event, or is not 0 or 1");
    }
    if (failure[row] == 1) {
      result.stop[row] = std::max(result.stop[row], limit);
    }
  }
  return result;
}

}  // namespace tcert::statistics
