#include <statistics/cox/cox_risk_sets.hpp>

#include <algorithm>
#include <numeric>
#include <statistics/basics/sort_order.hpp>
#include <statistics/basics/time_order.hpp>

namespace tcert::statistics {
namespace {

/// Rows by stratum, then by time; `first` has each stratum's first place, and the end.
std::vector<std::uint32_t> by_time(const SurvivalOutcome& outcome,
                                   const table::Factor* strata,
                                   std::vector<std::size_t>& first) {
  first.assign(strata == nullptr ? 2 : strata->levels.size() + 1, 0);
  if (strata == nullptr) {
    first.back() = outcome.rows();
    return sort_order(outcome.stop);
  }
  for (const std::uint32_t code : strata->codes) {
    ++first[code + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  return group_order(sort_order(outcome.stop), strata->codes, first);
}

/// Distinct event times of every stratum, and the last one of every row.
void find_times(const SurvivalOutcome& outcome, const table::Factor* strata, RiskSets& sets) {
  std::vector<std::size_t> first;
  const std::vector<std::uint32_t> order = by_time(outcome, strata, first);
  sets.last.assign(outcome.rows(), RiskSets::kNever);
  sets.stratum_begin.push_back(0);
  for (std::size_t s = 0; s + 1 < first.size(); ++s) {
    for (std::size_t k = first[s]; k < first[s + 1];) {
      const double time = outcome.stop[order[k]];
      std::size_t end = k;
      bool has_event = false;
      for (; end < first[s + 1] && outcome.stop[order[end]] == time; ++end) {
        has_event = has_event || outcome.event[order[end]] != 0;
      }
      if (has_event) {
        sets.time.push_back(time);
      }
      if (sets.time.size() > sets.stratum_begin[s]) {
        for (; k < end; ++k) {
          sets.last[order[k]] = static_cast<std::uint32_t>(sets.time.size() - 1);
        }
      }
      k = end;
    }
    sets.stratum_of.resize(sets.time.size(), static_cast<std::uint32_t>(s));
    sets.stratum_begin.push_back(static_cast<std::uint32_t>(sets.time.size()));
  }
}

/// The first event time of every row: beyond its start, or its stratum's first.
void find_first(const SurvivalOutcome& outcome, RiskSets& sets) {
  sets.first = sets.last;
  for (std::size_t row = 0; row < sets.last.size(); ++row) {
    const std::uint32_t last = sets.last[row];
    if (last == RiskSets::kNever) {
      continue;
    }
    sets.first[row] = sets.stratum_begin[sets.stratum_of[last]];
    if (outcome.left_truncated()) {
      const auto begin = sets.time.begin() + sets.first[row];
      const auto end = sets.time.begin() + last + 1;
      const auto low = std::upper_bound(begin, end, outcome.start[row]);
      const bool never = low == end;
      sets.first[row] =
          never ? RiskSets::kNever : static_cast<std::uint32_t>(low - sets.time.begin());
      sets.last[row] = never ? RiskSets::kNever : last;
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
  find_times(outcome, strata, sets);
  find_first(outcome, sets);
  sort_by_last(outcome, sets);
  if (outcome.left_truncated()) {
    sort_by_first(sets);
  }
  return sets;
}

}  // namespace tcert::statistics
