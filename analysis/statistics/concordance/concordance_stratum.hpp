#pragma once
/// \file
/// The rows of one stratum in the order in which pairs are counted. Internal to C.

#include <cstddef>
#include <cstdint>
#include <span>
#include <statistics/basics/dense_ranks.hpp>
#include <statistics/concordance/concordance_pairs.hpp>
#include <vector>

namespace tcert::statistics {

/// A row as the counting sees it.
struct StratumRow {
  double weight = 0.0;
  std::uint32_t rank = 0;
  std::uint32_t row = 0;
};

/// Entry of a row into the risk set.
struct StratumEntry {
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

/// Strata are never compared.
struct Stratum {
  std::vector<StratumRow> rows;       ///< By epoch.
  std::vector<Epoch> epochs;          ///< Ascending; the first may have no events.
  std::vector<double> pair_weights;   ///< Per epoch; empty if they are all 1.
  std::vector<StratumEntry> entries;  ///< Ascending in start.
  std::size_t distinct = 0;           ///< Ranks are below it.

  [[nodiscard]] double pair_weight(std::size_t epoch) const {
    return pair_weights.empty() ? 1.0 : pair_weights[epoch];
  }
  [[nodiscard]] std::span<const StratumRow> events_of(std::size_t epoch) const {
    return std::span(rows).subspan(epochs[epoch].first,
                                   epochs[epoch].events_end - epochs[epoch].first);
  }
  [[nodiscard]] std::size_t last_of(std::size_t epoch) const {
    return epoch + 1 < epochs.size() ? epochs[epoch + 1].first : rows.size();
  }
};

/// Sum of the weights of `rows`.
[[nodiscard]] double sum_of_weights(std::span<const StratumRow> rows);

/// True if every weight that the stratum counts with is a whole number and their sum small.
[[nodiscard]] bool counts_whole(const Stratum& stratum);

/// One for each group of `rows.order`, with entries where rows are left-truncated and weights of
/// pairs where they differ. O(n log n) for tied events, else O(n).
[[nodiscard]] std::vector<Stratum> concordance_strata(const ConcordanceRows& rows,
                                                      const DenseRanks& ranks);

}  // namespace tcert::statistics
