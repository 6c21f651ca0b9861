#include <statistics/concordance/concordance_pairs.hpp>

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <statistics/basics/dense_ranks.hpp>
#include <statistics/concordance/concordance_stratum.hpp>
#include <statistics/concordance/prefix_sums.hpp>
#include <stdexcept>

namespace tcert::statistics {
namespace {

/// Weight of the rows that compare to one row, by side.
struct Sides {
  double below = 0.0;
  double tied = 0.0;
  double above = 0.0;

  [[nodiscard]] double all() const noexcept { return below + tied + above; }
};

/// Weights by rank. `T` is a whole number if all weights are: half the memory, and twice the speed
/// where the cache does not hold them.
template <typename T>
class RankWeights {
 public:
  explicit RankWeights(std::size_t distinct) : sums_(distinct), of_rank_(distinct, T{0}) {}

  void add(std::uint32_t rank, double weight) noexcept { change(rank, static_cast<T>(weight)); }
  void remove(std::uint32_t rank, double weight) noexcept {
    change(rank, T{0} - static_cast<T>(weight));  // unsigned numbers wrap
  }
  [[nodiscard]] Sides sides(std::uint32_t rank) const noexcept {
    const T below = sums_.before(rank);
    const T tied = of_rank_[rank];
    return {static_cast<double>(below),
            static_cast<double>(tied),
            static_cast<double>(sums_.total() - below - tied)};
  }
  [[nodiscard]] double of_rank(std::uint32_t rank) const noexcept {
    return static_cast<double>(of_rank_[rank]);
  }
  [[nodiscard]] double total() const noexcept { return static_cast<double>(sums_.total()); }

 private:
  void change(std::uint32_t rank, T weight) noexcept {
    sums_.add(rank, weight);
    of_rank_[rank] += weight;
  }

  PrefixSums<T> sums_;
  std::vector<T> of_rank_;
};

struct StratumPairs {
  ConcordanceCounts counts;
  double score_variance = 0.0;
};

/// Latest first: each event against the rows at risk that outlive it. Sets `pairs` of the events.
///
/// The score variance adds up the mean of (weight below - weight above)^2 over each risk set. That
/// sum of squares is (W^3 - sum of t^3) / 3 with t the weight of each tied rank; it is kept up by
/// differences that do not cancel.
template <typename T>
StratumPairs count_outliving(const Stratum& stratum, std::vector<RowPairs>& pairs) {
  RankWeights<T> at_risk(stratum.distinct);
  StratumPairs result;
  double spread = 0.0;
  const auto change_of_spread = [&](const StratumRow& row) {
    const double total = at_risk.total();
    const double tied = at_risk.of_rank(row.rank);
    return row.weight * (total - tied) * (total + tied + row.weight);
  };
  const auto add = [&](const StratumRow& row) {
    spread += change_of_spread(row);
    at_risk.add(row.rank, row.weight);
  };
  auto entry = stratum.entries.rbegin();
  for (std::size_t epoch = stratum.epochs.size(); epoch-- > 0;) {
    for (std::size_t k = stratum.epochs[epoch].events_end; k < stratum.last_of(epoch); ++k) {
      add(stratum.rows[k]);
    }
    const double time = stratum.epochs[epoch].time;
    for (; entry != stratum.entries.rend() && entry->start >= time; ++entry) {
      const StratumRow& row = stratum.rows[entry->at];
      at_risk.remove(row.rank, row.weight);
      spread -= change_of_spread(row);
    }
    const std::span<const StratumRow> events = stratum.events_of(epoch);
    const double weight = stratum.pair_weight(epoch);
    for (const StratumRow& row : events) {
      const Sides sides = at_risk.sides(row.rank);
      pairs[row.row] = {weight * (sides.above - sides.below), weight * sides.all()};
      result.counts.concordant += weight * row.weight * sides.above;
      result.counts.discordant += weight * row.weight * sides.below;
      result.counts.tied_x += weight * row.weight * sides.tied;
    }
    std::for_each(events.begin(), events.end(), add);
    if (at_risk.total() > 0.0) {
      result.score_variance += sum_of_weights(events) * weight * weight * spread / at_risk.total();
    }
  }
  return result;
}

/// Earliest first: each row against the events that it outlives while at risk. `pairs` as `rows`.
template <typename T>
void count_outlived(const Stratum& stratum, std::vector<RowPairs>& pairs) {
  RankWeights<T> events(stratum.distinct);
  const auto look = [&](std::size_t k, double sign) {
    const Sides sides = events.sides(stratum.rows[k].rank);
    pairs[k].net += sign * (sides.below - sides.above);
    pairs[k].comparable += sign * sides.all();
  };
  auto entry = stratum.entries.begin();
  for (std::size_t epoch = 0; epoch < stratum.epochs.size(); ++epoch) {
    const auto [time, first, events_end] = stratum.epochs[epoch];
    for (; entry != stratum.entries.end() && entry->start < time; ++entry) {
      look(entry->at, -1.0);
    }
    for (std::size_t k = first; k < events_end; ++k) {
      look(k, 1.0);
    }
    for (const StratumRow& row : stratum.events_of(epoch)) {
      events.add(row.rank, row.weight * stratum.pair_weight(epoch));
    }
    for (std::size_t k = events_end; k < stratum.last_of(epoch); ++k) {
      look(k, 1.0);
    }
  }
  // Rows that enter when all events are over outlive none of them.
  for (; entry != stratum.entries.end(); ++entry) {
    look(entry->at, -1.0);
  }
}

/// Pairs of events at the same time.
void count_tied_events(std::span<const StratumRow> events,
                       double weight,
                       ConcordanceCounts& counts) {
  double before = 0.0;
  for (auto first = events.begin(); first != events.end();) {
    const std::uint32_t rank = first->rank;
    double tied = 0.0;
    for (; first != events.end() && first->rank == rank; ++first) {
      counts.tied_xy += weight * first->weight * tied;
      tied += first->weight;
    }
    counts.tied_y += weight * before * tied;
    before += tied;
  }
}

template <typename T>
StratumPairs count_pairs(const Stratum& stratum, std::vector<RowPairs>& pairs) {
  std::vector<RowPairs> outlived(stratum.rows.size());
  StratumPairs result;
  const auto later = [&] { result = count_outliving<T>(stratum, pairs); };
  const auto earlier = [&] { count_outlived<T>(stratum, outlived); };
  constexpr std::size_t kWorthAThread = 10'000;
  if (stratum.rows.size() < kWorthAThread) {
    later();
    earlier();
  } else {
    tbb::parallel_invoke(later, earlier);
  }
  for (std::size_t k = 0; k < stratum.rows.size(); ++k) {
    pairs[stratum.rows[k].row].net += outlived[k].net;
    pairs[stratum.rows[k].row].comparable += outlived[k].comparable;
  }
  for (std::size_t epoch = 0; epoch < stratum.epochs.size(); ++epoch) {
    count_tied_events(stratum.events_of(epoch), stratum.pair_weight(epoch), result.counts);
  }
  return result;
}

void check(const ConcordanceRows& rows) {
  const std::size_t n = rows.outcome->rows();
  if (rows.order->by_stop.size() != n || (!rows.weight.empty() && rows.weight.size() != n)) {
    throw std::invalid_argument("concordance: columns of different length");
  }
  if (!std::all_of(rows.weight.begin(), rows.weight.end(), [](double weight) {
        return std::isfinite(weight) && weight >= 0.0;
      })) {
    throw std::invalid_argument("concordance: a weight is negative or not finite");
  }
  const bool needs_censoring = rows.pair_weight == PairWeight::survival_by_censoring ||
                               rows.pair_weight == PairWeight::inverse_censoring_squared;
  if (needs_censoring && rows.outcome->left_truncated()) {
    throw std::invalid_argument(
        "concordance: (start, stop] rows have no weights by the censoring distribution");
  }
}

}  // namespace

ConcordanceCounts& ConcordanceCounts::operator+=(const ConcordanceCounts& other) noexcept {
  concordant += other.concordant;
  discordant += other.discordant;
  tied_x += other.tied_x;
  tied_y += other.tied_y;
  tied_xy += other.tied_xy;
  return *this;
}

double concordance_index(const ConcordanceCounts& counts) noexcept {
  return (counts.concordant + 0.5 * counts.tied_x) / counts.comparable();
}

ConcordanceCounts ConcordancePairs::total() const noexcept {
  ConcordanceCounts sum;
  for (const ConcordanceCounts& counts : by_stratum) {
    sum += counts;
  }
  return sum;
}

ConcordancePairs concordance_pairs(const ConcordanceRows& rows, std::span<const double> larger) {
  check(rows);
  const DenseRanks ranks = dense_ranks(larger, *rows.order);
  ConcordancePairs result;
  result.rows.resize(larger.size());
  for (const Stratum& stratum : concordance_strata(rows, ranks)) {
    const StratumPairs pairs = counts_whole(stratum)
                                   ? count_pairs<std::uint32_t>(stratum, result.rows)
                                   : count_pairs<double>(stratum, result.rows);
    result.by_stratum.push_back(pairs.counts);
    result.score_variance += pairs.score_variance;
  }
  return result;
}

}  // namespace tcert::statistics
