#include <statistics/cox/cox_risk_sets.hpp>

#include <algorithm>

namespace tcert::statistics {
namespace {

std::size_t stratum_of_row(const table::Factor* strata, std::size_t row) {
  return strata == nullptr ? 0 : strata->codes[row];
}

/// Distinct event times of every stratum.
void find_event_times(const SurvivalOutcome& outcome, const table::Factor* strata, RiskSets& sets) {
  const std::size_t count = strata == nullptr ? 1 : strata->levels.size();
  std::vector<std::vector<double>> times(count);
  std::vector<std::size_t> events(count, 0);
  for (std::size_t row = 0; row < outcome.rows(); ++row) {
    events[stratum_of_row(strata, row)] += outcome.event[row];
  }
  for (std::size_t s = 0; s < count; ++s) {
    times[s].reserve(events[s]);
  }
  for (std::size_t row = 0; row < outcome.rows(); ++row) {
    if (outcome.event[row] != 0) {
      times[stratum_of_row(strata, row)].push_back(outcome.stop[row]);
    }
  }
  sets.stratum_begin.push_back(0);
  for (std::size_t s = 0; s < count; ++s) {
    std::sort(times[s].begin(), times[s].end());
    const auto end = std::unique(times[s].begin(), times[s].end());
    sets.time.insert(sets.time.end(), times[s].begin(), end);
    sets.stratum_of.resize(sets.time.size(), static_cast<std::uint32_t>(s));
    sets.stratum_begin.push_back(static_cast<std::uint32_t>(sets.time.size()));
  }
}

/// The range of event times of every row.
void find_ranges(const SurvivalOutcome& outcome, const table::Factor* strata, RiskSets& sets) {
  const std::size_t rows = outcome.rows();
  sets.first.assign(rows, RiskSets::kNever);
  sets.last.assign(rows, RiskSets::kNever);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::size_t s = stratum_of_row(strata, row);
    const auto begin = sets.time.begin() + sets.stratum_begin[s];
    const auto end = sets.time.begin() + sets.stratum_begin[s + 1];
    // The first time beyond `start` and the last one not beyond `stop`.
    const auto low =
        outcome.left_truncated() ? std::upper_bound(begin, end, outcome.start[row]) : begin;
    const auto high = std::upper_bound(low, end, outcome.stop[row]);
    if (low != high) {
      sets.first[row] = static_cast<std::uint32_t>(low - sets.time.begin());
      sets.last[row] = static_cast<std::uint32_t>(high - sets.time.begin() - 1);
    }
  }
}

/// Turns counts at [k + 1] into beginnings at [k].
void accumulate(std::vector<std::uint32_t>& counts) {
  for (std::size_t k = 1; k < counts.size(); ++k) {
    counts[k] += counts[k - 1];
  }
}

void sort_by_last(const SurvivalOutcome& outcome, RiskSets& sets) {
  const std::size_t rows = outcome.rows();
  // Two buckets a time, so that one counting sort parts the censored from the events.
  std::vector<std::uint32_t> begin(2 * sets.times() + 1, 0);
  const auto bucket = [&](std::size_t row) {
    return 2 * static_cast<std::size_t>(sets.last[row]) + (outcome.event[row] != 0 ? 1U : 0U);
  };
  for (std::size_t row = 0; row < rows; ++row) {
    if (sets.last[row] != RiskSets::kNever) {
      ++begin[bucket(row) + 1];
    }
  }
  accumulate(begin);
  sets.begin.resize(sets.times() + 1);
  sets.events_begin.resize(sets.times());
  for (std::size_t t = 0; t < sets.times(); ++t) {
    sets.begin[t] = begin[2 * t];
    sets.events_begin[t] = begin[2 * t + 1];
  }
  sets.begin.back() = begin.back();
  sets.order.resize(begin.back());
  for (std::size_t row = 0; row < rows; ++row) {
    if (sets.last[row] != RiskSets::kNever) {
      sets.order[begin[bucket(row)]++] = static_cast<std::uint32_t>(row);
    }
  }
}

void sort_by_first(RiskSets& sets) {
  const auto is_late = [&](std::uint32_t row) {
    return sets.first[row] != sets.stratum_begin[sets.stratum_of[sets.first[row]]];
  };
  std::vector<std::uint32_t> begin(sets.times() + 1, 0);
  for (const std::uint32_t row : sets.order) {
    if (is_late(row)) {
      ++begin[sets.first[row] + 1];
    }
  }
  accumulate(begin);
  if (begin.back() == 0) {
    return;
  }
  sets.late.resize(begin.back());
  sets.late_begin = begin;
  for (std::size_t place = 0; place < sets.order.size(); ++place) {
    const std::uint32_t row = sets.order[place];
    if (is_late(row)) {
      sets.late[begin[sets.first[row]]++] = static_cast<std::uint32_t>(place);
    }
  }
}

}  // namespace

RiskSets risk_sets(const SurvivalOutcome& outcome, const table::Factor* strata) {
  RiskSets sets;
  find_event_times(outcome, strata, sets);
  find_ranges(outcome, strata, sets);
  sort_by_last(outcome, sets);
  if (outcome.left_truncated()) {
    sort_by_first(sets);
  }
  return sets;
}

}  // namespace tcert::statistics
