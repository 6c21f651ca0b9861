#include <statistics/concordance/concordance_replicates.hpp>

#include <algorithm>
#include <statistics/basics/dense_ranks.hpp>
#include <statistics/basics/time_order.hpp>
#include <stdexcept>
#include <utility>

namespace tcert::statistics {
namespace {

bool common_start(const SurvivalOutcome& outcome) {
  return std::all_of(outcome.start.begin(), outcome.start.end(), [&](double start) {
    return start == outcome.start[0];
  });
}

}  // namespace

ConcordanceReplicates::ConcordanceReplicates(const SurvivalOutcome& outcome,
                                             const Predictor& predictor,
                                             const table::Factor* strata)
    : larger_(predictor.larger), rows_(outcome.rows()) {
  const std::size_t groups = strata == nullptr ? 1 : strata->levels.size();
  const TimeOrder order =
      time_order(outcome,
                 strata == nullptr ? std::span<const std::uint32_t>{} : std::span(strata->codes),
                 groups);
  const DenseRanks ranks = dense_ranks(predictor.values, order);
  const bool truncated = outcome.left_truncated() && !common_start(outcome);
  visits_.reserve((truncated ? 3 : 2) * rows_ + groups);
  for (std::size_t group = 0; group < groups; ++group) {
    if (group > 0) {
      visits_.push_back({0, 0, Step::next_stratum});
    }
    distinct_ = std::max(distinct_, ranks.distinct[group]);
    add_stratum(outcome,
                order.stops_of(group),
                truncated ? order.starts_of(group) : std::span<const std::uint32_t>{},
                ranks.rank);
  }
}

void ConcordanceReplicates::add_stratum(const SurvivalOutcome& outcome,
                                        std::span<const std::uint32_t> by_stop,
                                        std::span<const std::uint32_t> by_start,
                                        std::span<const std::uint32_t> ranks) {
  const auto visit = [&](std::uint32_t row, Step step) {
    visits_.push_back({row, ranks[row], step});
  };
  std::size_t entered = by_start.size();  // starts before the present time
  for (std::size_t last = by_stop.size(); last > 0;) {
    const double time = outcome.stop[by_stop[last - 1]];
    std::size_t first = last;
    while (first > 0 && outcome.stop[by_stop[first - 1]] == time) {
      --first;
    }
    std::size_t events_end = first;
    while (events_end < last && outcome.event[by_stop[events_end]] != 0) {
      ++events_end;
    }
    for (std::size_t k = events_end; k < last; ++k) {
      visit(by_stop[k], Step::enter);
    }
    if (events_end > first) {
      for (; entered > 0 && outcome.start[by_start[entered - 1]] >= time; --entered) {
        visit(by_start[entered - 1], Step::leave);
      }
    }
    for (std::size_t k = first; k < events_end; ++k) {
      visit(by_stop[k], Step::compare);
    }
    for (std::size_t k = first; k < events_end; ++k) {
      visit(by_stop[k], Step::enter);
    }
    last = first;
  }
}

ConcordanceReplicates::Counts ConcordanceReplicates::directed(Counts counts) const noexcept {
  if (larger_ == LargerMeans::shorter_time) {
    std::swap(counts.concordant, counts.discordant);
  }
  return counts;
}

ConcordanceReplicates::Counts ConcordanceReplicates::counts(
    std::span<const std::uint32_t> multiplicity, Scratch& scratch) const {
  if (multiplicity.size() != rows_) {
    throw std::invalid_argument("concordance: a multiplicity per row is needed");
  }
  scratch.reset(distinct_);
  Counts counts;
  for (const Visit& visit : visits_) {
    if (visit.step == Step::next_stratum) {
      scratch.reset(distinct_);
      continue;
    }
    const std::uint32_t times = multiplicity[visit.row];
    if (times == 0) {
      continue;
    }
    if (visit.step == Step::compare) {
      counts += scratch.against(visit.rank, times);
    } else {
      // Unsigned arithmetic wraps, so that taking away is adding the complement.
      scratch.add(visit.rank, visit.step == Step::enter ? times : 0U - times);
    }
  }
  return directed(counts);
}

double ConcordanceReplicates::c(std::span<const std::uint32_t> multiplicity,
                                Scratch& scratch) const {
  const Counts pairs = counts(multiplicity, scratch);
  return concordance_index({static_cast<double>(pairs.concordant),
                            static_cast<double>(pairs.discordant),
                            static_cast<double>(pairs.tied_x)});
}

}  // namespace tcert::statistics
