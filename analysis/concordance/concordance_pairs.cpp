#include "analysis/concordance/concordance_pairs.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "analysis/basics/dense_ranks.hpp"
#include "analysis/concordance/prefix_sums.hpp"

namespace tcert {
namespace {

struct Row {
  double weight = 0.0;
  std::uint32_t rank = 0;
  std::uint32_t row = 0;
};

/// Entry of a row into the risk set.
struct Entry {
  double start = 0.0;
  std::uint32_t at = 0;  ///< Index into Stratum::rows.
};

/// Rows that stop from one event time until before the next. Those with their event come first, by
/// rank; the rest are censored and leave the risk set between the two times, all the same when.
struct Epoch {
  double time = 0.0;
  std::uint32_t first = 0;
  std::uint32_t events_end = 0;
};

struct Stratum {
  std::vector<Row> rows;             ///< By epoch.
  std::vector<Epoch> epochs;         ///< Ascending; the first may have no events.
  std::vector<double> pair_weights;  ///< Per epoch; empty if they are all 1.
  std::vector<Entry> entries;        ///< Ascending in start.
  std::size_t distinct = 0;          ///< Ranks are below it.

  [[nodiscard]] double pair_weight(std::size_t epoch) const {
    return pair_weights.empty() ? 1.0 : pair_weights[epoch];
  }
  [[nodiscard]] std::span<const Row> events_of(std::size_t epoch) const {
    return std::span(rows).subspan(epochs[epoch].first,
                                   epochs[epoch].events_end - epochs[epoch].first);
  }
  [[nodiscard]] std::size_t last_of(std::size_t epoch) const {
    return epoch + 1 < epochs.size() ? epochs[epoch + 1].first : rows.size();
  }
};

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

double sum_of_weights(std::span<const Row> rows) {
  return std::accumulate(
      rows.begin(), rows.end(), 0.0, [](double sum, const Row& row) { return sum + row.weight; });
}

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
  const auto change_of_spread = [&](const Row& row) {
    const double total = at_risk.total();
    const double tied = at_risk.of_rank(row.rank);
    return row.weight * (total - tied) * (total + tied + row.weight);
  };
  const auto add = [&](const Row& row) {
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
      const Row& row = stratum.rows[entry->at];
      at_risk.remove(row.rank, row.weight);
      spread -= change_of_spread(row);
    }
    const std::span<const Row> events = stratum.events_of(epoch);
    const double weight = stratum.pair_weight(epoch);
    for (const Row& row : events) {
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
    for (const Row& row : stratum.events_of(epoch)) {
      events.add(row.rank, row.weight * stratum.pair_weight(epoch));
    }
    for (std::size_t k = events_end; k < stratum.last_of(epoch); ++k) {
      look(k, 1.0);
    }
  }
}

/// Pairs of events at the same time.
void count_tied_events(std::span<const Row> events, double weight, ConcordanceCounts& counts) {
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

/// True if every weight that the stratum counts with is a whole number and their sum small.
bool counts_whole(const Stratum& stratum) {
  constexpr double kLargest = 4294967295.0;
  return stratum.pair_weights.empty() && sum_of_weights(stratum.rows) <= kLargest &&
         std::all_of(stratum.rows.begin(), stratum.rows.end(), [](const Row& row) {
           return row.weight == std::floor(row.weight);
         });
}

Stratum make_stratum(const ConcordanceRows& rows, std::size_t group, const DenseRanks& ranks) {
  const SurvivalOutcome& outcome = *rows.outcome;
  const std::span<const std::uint32_t> stops = rows.order->stops_of(group);
  Stratum stratum;
  stratum.distinct = ranks.distinct[group];
  stratum.rows.reserve(stops.size());
  for (const std::uint32_t row : stops) {
    const double time = outcome.stop[row];
    const bool event = outcome.event[row] != 0;
    if (stratum.epochs.empty() || (event && stratum.epochs.back().time < time)) {
      const auto at = static_cast<std::uint32_t>(stratum.rows.size());
      stratum.epochs.push_back({event ? time : -std::numeric_limits<double>::infinity(), at, at});
    }
    stratum.rows.push_back({rows.weight.empty() ? 1.0 : rows.weight[row], ranks.rank[row], row});
    if (event) {
      stratum.epochs.back().events_end = static_cast<std::uint32_t>(stratum.rows.size());
    }
  }
  for (const Epoch& epoch : stratum.epochs) {
    const auto at = [&](std::size_t k) {
      return stratum.rows.begin() + static_cast<std::ptrdiff_t>(k);
    };
    if (epoch.events_end - epoch.first > 1) {
      std::sort(at(epoch.first), at(epoch.events_end), [](const Row& a, const Row& b) {
        return a.rank != b.rank ? a.rank < b.rank : a.row < b.row;
      });
    }
  }
  return stratum;
}

void add_entries(const ConcordanceRows& rows,
                 std::size_t group,
                 std::vector<std::uint32_t>& position,
                 Stratum& stratum) {
  for (std::size_t k = 0; k < stratum.rows.size(); ++k) {
    position[stratum.rows[k].row] = static_cast<std::uint32_t>(k);
  }
  stratum.entries.reserve(stratum.rows.size());
  for (const std::uint32_t row : rows.order->starts_of(group)) {
    stratum.entries.push_back({rows.outcome->start[row], position[row]});
  }
}

double weight_of_pairs(PairWeight kind, double all, double at_risk, double survival, double free) {
  switch (kind) {
    case PairWeight::equal:
      break;
    case PairWeight::survival:
      return all * survival / at_risk;
    case PairWeight::survival_by_censoring:
      return all * survival / (free * at_risk);
    case PairWeight::inverse_censoring_squared:
      return 1.0 / (free * free);
    case PairWeight::inverse_at_risk:
      return 1.0 / at_risk;
  }
  return 1.0;
}

/// Sets the weights of the epochs' pairs.
void weigh_epochs(const ConcordanceRows& rows, Stratum& stratum) {
  if (rows.pair_weight == PairWeight::equal && std::isinf(rows.last_event)) {
    return;
  }
  const double all = sum_of_weights(stratum.rows);
  double stopped = 0.0;  // weight of the rows that stopped before the epoch
  double entered = stratum.entries.empty() ? all : 0.0;
  double survival = 1.0;     // Kaplan-Meier just before the epoch
  double free = 1.0;         // the same of censoring, events at a time before censoring at it
  double left_before = all;  // at risk after the events of the last epoch
  auto entry = stratum.entries.begin();
  stratum.pair_weights.assign(stratum.epochs.size(), 1.0);
  for (std::size_t epoch = 0; epoch < stratum.epochs.size(); ++epoch) {
    const auto [time, first, events_end] = stratum.epochs[epoch];
    for (; entry != stratum.entries.end() && entry->start < time; ++entry) {
      entered += stratum.rows[entry->at].weight;
    }
    const double at_risk = entered - stopped;
    const double events = sum_of_weights(stratum.events_of(epoch));
    if (events > 0.0 && at_risk > 0.0) {
      free *= at_risk / left_before;
      stratum.pair_weights[epoch] = weight_of_pairs(rows.pair_weight, all, at_risk, survival, free);
      survival *= (at_risk - events) / at_risk;
      left_before = at_risk - events;
    }
    if (time > rows.last_event) {
      stratum.pair_weights[epoch] = 0.0;
    }
    stopped +=
        sum_of_weights(std::span(stratum.rows).subspan(first, stratum.last_of(epoch) - first));
  }
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
  std::vector<std::uint32_t> position(rows.outcome->left_truncated() ? larger.size() : 0);
  for (std::size_t group = 0; group < rows.order->groups(); ++group) {
    Stratum stratum = make_stratum(rows, group, ranks);
    if (rows.outcome->left_truncated()) {
      add_entries(rows, group, position, stratum);
    }
    weigh_epochs(rows, stratum);
    const StratumPairs pairs = counts_whole(stratum)
                                   ? count_pairs<std::uint32_t>(stratum, result.rows)
                                   : count_pairs<double>(stratum, result.rows);
    result.by_stratum.push_back(pairs.counts);
    result.score_variance += pairs.score_variance;
  }
  return result;
}

}  // namespace tcert
