#include "analysis/concordance_pairs.hpp"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "analysis/dense_ranks.hpp"
#include "analysis/prefix_sums.hpp"

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
  double pair_weight = 1.0;
  std::size_t first = 0;
  std::size_t events_end = 0;
  std::size_t last = 0;
};

struct Stratum {
  std::vector<Row> rows;       ///< By epoch.
  std::vector<Epoch> epochs;   ///< Ascending; the first may have no events.
  std::vector<Entry> entries;  ///< Ascending in start.
  std::size_t distinct = 0;    ///< Ranks are below it.
};

/// Weight of the rows that compare to one row, by side.
struct Sides {
  double below = 0.0;
  double tied = 0.0;
  double above = 0.0;
};

/// Weights by rank.
class RankWeights {
 public:
  explicit RankWeights(std::size_t distinct) : sums_(distinct), of_rank_(distinct, 0.0) {}

  void add(std::uint32_t rank, double weight) noexcept {
    sums_.add(rank, weight);
    of_rank_[rank] += weight;
  }
  [[nodiscard]] Sides sides(std::uint32_t rank) const noexcept {
    const double below = sums_.before(rank);
    const double tied = of_rank_[rank];
    return {below, tied, sums_.total() - below - tied};
  }
  [[nodiscard]] double of_rank(std::uint32_t rank) const noexcept { return of_rank_[rank]; }
  [[nodiscard]] double total() const noexcept { return sums_.total(); }

 private:
  PrefixSums<double> sums_;
  std::vector<double> of_rank_;
};

/// Sum over a risk set of w (weight below - weight above)^2, which is (W^3 - sum of t^3) / 3 with t
/// the weight of each tied rank; kept up by differences that do not cancel.
class RankSpread {
 public:
  explicit RankSpread(const RankWeights& weights) : weights_(&weights) {}

  /// Call before the row is added, with its weight.
  void before_adding(const Row& row) noexcept { spread_ += change(row); }
  /// Call after the row has been removed.
  void after_removing(const Row& row) noexcept { spread_ -= change(row); }
  [[nodiscard]] double mean() const noexcept { return spread_ / weights_->total(); }

 private:
  [[nodiscard]] double change(const Row& row) const noexcept {
    const double total = weights_->total();
    const double tied = weights_->of_rank(row.rank);
    return row.weight * (total - tied) * (total + tied + row.weight);
  }

  const RankWeights* weights_;
  double spread_ = 0.0;
};

double sum_of_weights(std::span<const Row> rows) {
  return std::accumulate(
      rows.begin(), rows.end(), 0.0, [](double sum, const Row& row) { return sum + row.weight; });
}

std::span<const Row> events_of(const Stratum& stratum, const Epoch& epoch) {
  return std::span(stratum.rows).subspan(epoch.first, epoch.events_end - epoch.first);
}

/// Latest first: for each event the weight of the rows at risk that outlive it, into `seen`.
/// Returns the score variance.
double count_outliving(const Stratum& stratum, std::vector<Sides>& seen) {
  RankWeights at_risk(stratum.distinct);
  RankSpread spread(at_risk);
  double score_variance = 0.0;
  const auto add = [&](const Row& row) {
    spread.before_adding(row);
    at_risk.add(row.rank, row.weight);
  };
  auto entry = stratum.entries.rbegin();
  for (auto epoch = stratum.epochs.rbegin(); epoch != stratum.epochs.rend(); ++epoch) {
    for (std::size_t k = epoch->events_end; k < epoch->last; ++k) {
      add(stratum.rows[k]);
    }
    for (; entry != stratum.entries.rend() && entry->start >= epoch->time; ++entry) {
      const Row& row = stratum.rows[entry->at];
      at_risk.add(row.rank, -row.weight);
      spread.after_removing(row);
    }
    for (std::size_t k = epoch->first; k < epoch->events_end; ++k) {
      seen[k] = at_risk.sides(stratum.rows[k].rank);
    }
    const std::span<const Row> events = events_of(stratum, *epoch);
    std::for_each(events.begin(), events.end(), add);
    if (at_risk.total() > 0.0 && epoch->pair_weight > 0.0) {
      score_variance +=
          sum_of_weights(events) * epoch->pair_weight * epoch->pair_weight * spread.mean();
    }
  }
  return score_variance;
}

/// Earliest first: for each row the weight of the events that it outlives while at risk.
void count_outlived(const Stratum& stratum, std::vector<Sides>& seen) {
  RankWeights events(stratum.distinct);
  auto entry = stratum.entries.begin();
  for (const Epoch& epoch : stratum.epochs) {
    for (; entry != stratum.entries.end() && entry->start < epoch.time; ++entry) {
      const Sides before = events.sides(stratum.rows[entry->at].rank);
      seen[entry->at].below -= before.below;
      seen[entry->at].tied -= before.tied;
      seen[entry->at].above -= before.above;
    }
    const auto look = [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) {
        const Sides sides = events.sides(stratum.rows[k].rank);
        seen[k].below += sides.below;
        seen[k].tied += sides.tied;
        seen[k].above += sides.above;
      }
    };
    look(epoch.first, epoch.events_end);
    for (const Row& row : events_of(stratum, epoch)) {
      events.add(row.rank, row.weight * epoch.pair_weight);
    }
    look(epoch.events_end, epoch.last);
  }
}

/// Pairs of events at the same time.
void count_tied_events(const Stratum& stratum,
                       const Epoch& epoch,
                       ConcordanceCounts& counts,
                       std::vector<ConcordanceCounts>& influence) {
  const std::span<const Row> events = events_of(stratum, epoch);
  if (events.size() < 2) {
    return;
  }
  const double all = sum_of_weights(events);
  double different = 0.0;
  double same = 0.0;
  double weight_before = 0.0;
  for (auto first = events.begin(); first != events.end();) {
    const auto last =
        std::find_if(first, events.end(), [&](const Row& row) { return row.rank != first->rank; });
    const double tied = sum_of_weights({first, last});
    different += tied * weight_before;
    weight_before += tied;
    double tied_before = 0.0;
    for (; first != last; ++first) {
      same += first->weight * tied_before;
      tied_before += first->weight;
      influence[first->row].tied_xy += epoch.pair_weight * (tied - first->weight);
      influence[first->row].tied_y += epoch.pair_weight * (all - tied);
    }
  }
  counts.tied_y += epoch.pair_weight * different;
  counts.tied_xy += epoch.pair_weight * same;
}

struct StratumPairs {
  ConcordanceCounts counts;
  double score_variance = 0.0;
};

StratumPairs count_pairs(const Stratum& stratum, std::vector<ConcordanceCounts>& influence) {
  std::vector<Sides> outliving(stratum.rows.size());
  std::vector<Sides> outlived(stratum.rows.size());
  StratumPairs result;
  const auto later = [&] { result.score_variance = count_outliving(stratum, outliving); };
  const auto earlier = [&] { count_outlived(stratum, outlived); };
  constexpr std::size_t kWorthAThread = 10'000;
  if (stratum.rows.size() < kWorthAThread) {
    later();
    earlier();
  } else {
    tbb::parallel_invoke(later, earlier);
  }

  for (std::size_t k = 0; k < stratum.rows.size(); ++k) {
    ConcordanceCounts& pairs = influence[stratum.rows[k].row];
    pairs.concordant = outlived[k].below;
    pairs.discordant = outlived[k].above;
    pairs.tied_x = outlived[k].tied;
  }
  for (const Epoch& epoch : stratum.epochs) {
    for (std::size_t k = epoch.first; k < epoch.events_end; ++k) {
      const Row& row = stratum.rows[k];
      ConcordanceCounts pairs;
      pairs.concordant = outliving[k].above * epoch.pair_weight;
      pairs.discordant = outliving[k].below * epoch.pair_weight;
      pairs.tied_x = outliving[k].tied * epoch.pair_weight;
      influence[row.row] += pairs;
      result.counts.concordant += pairs.concordant * row.weight;
      result.counts.discordant += pairs.discordant * row.weight;
      result.counts.tied_x += pairs.tied_x * row.weight;
    }
    count_tied_events(stratum, epoch, result.counts, influence);
  }
  return result;
}

/// Rows of a stratum as epochs, ranks still without meaning if `ranks` is null.
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
      const std::size_t at = stratum.rows.size();
      stratum.epochs.push_back(
          {event ? time : -std::numeric_limits<double>::infinity(), 1.0, at, at, at});
    }
    stratum.rows.push_back({rows.weight.empty() ? 1.0 : rows.weight[row], ranks.rank[row], row});
    stratum.epochs.back().last = stratum.rows.size();
    if (event) {
      stratum.epochs.back().events_end = stratum.rows.size();
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

/// Weights of the epochs' pairs.
void weigh_epochs(const ConcordanceRows& rows, Stratum& stratum) {
  const double all = sum_of_weights(stratum.rows);
  double stopped = 0.0;  // weight of the rows that stopped before the epoch
  double entered = stratum.entries.empty() ? all : 0.0;
  double survival = 1.0;     // Kaplan-Meier just before the epoch
  double free = 1.0;         // the same of censoring, events at a time before censoring at it
  double left_before = all;  // at risk after the events of the last epoch
  auto entry = stratum.entries.begin();
  for (Epoch& epoch : stratum.epochs) {
    for (; entry != stratum.entries.end() && entry->start < epoch.time; ++entry) {
      entered += stratum.rows[entry->at].weight;
    }
    const double at_risk = entered - stopped;
    const double events = sum_of_weights(events_of(stratum, epoch));
    if (events > 0.0 && at_risk > 0.0) {
      free *= at_risk / left_before;
      epoch.pair_weight = weight_of_pairs(rows.pair_weight, all, at_risk, survival, free);
      survival *= (at_risk - events) / at_risk;
      left_before = at_risk - events;
    }
    if (epoch.time > rows.last_event) {
      epoch.pair_weight = 0.0;
    }
    stopped +=
        sum_of_weights(std::span(stratum.rows).subspan(epoch.first, epoch.last - epoch.first));
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
  result.influence.resize(larger.size());
  std::vector<std::uint32_t> position(rows.outcome->left_truncated() ? larger.size() : 0);
  for (std::size_t group = 0; group < rows.order->groups(); ++group) {
    Stratum stratum = make_stratum(rows, group, ranks);
    if (rows.outcome->left_truncated()) {
      add_entries(rows, group, position, stratum);
    }
    weigh_epochs(rows, stratum);
    const StratumPairs pairs = count_pairs(stratum, result.influence);
    result.by_stratum.push_back(pairs.counts);
    result.score_variance += pairs.score_variance;
  }
  return result;
}

}  // namespace tcert
