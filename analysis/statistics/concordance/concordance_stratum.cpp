#include <statistics/concordance/concordance_stratum.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace tcert::statistics {
namespace {

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
      std::sort(
          at(epoch.first), at(epoch.events_end), [](const StratumRow& a, const StratumRow& b) {
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

}  // namespace

double sum_of_weights(std::span<const StratumRow> rows) {
  return std::accumulate(rows.begin(), rows.end(), 0.0, [](double sum, const StratumRow& row) {
    return sum + row.weight;
  });
}

bool counts_whole(const Stratum& stratum) {
  constexpr double kLargest = 4294967295.0;
  return stratum.pair_weights.empty() && sum_of_weights(stratum.rows) <= kLargest &&
         std::all_of(stratum.rows.begin(), stratum.rows.end(), [](const StratumRow& row) {
           return row.weight == std::floor(row.weight);
         });
}

std::vector<Stratum> concordance_strata(const ConcordanceRows& rows, const DenseRanks& ranks) {
  std::vector<Stratum> strata;
  strata.reserve(rows.order->groups());
  std::vector<std::uint32_t> position(rows.outcome->left_truncated() ? rows.outcome->rows() : 0);
  for (std::size_t group = 0; group < rows.order->groups(); ++group) {
    strata.push_back(make_stratum(rows, group, ranks));
    if (rows.outcome->left_truncated()) {
      add_entries(rows, group, position, strata.back());
    }
    weigh_epochs(rows, strata.back());
  }
  return strata;
}

}  // namespace tcert::statistics
