#pragma once
/// \file
/// Counts of concordant, discordant and tied pairs of survival times and a predictor, in all and by
/// row: what Harrell's C and its variance are made of. Checked against `survival::concordance`.

#include <cstdint>
#include <limits>
#include <span>
#include <statistics/basics/time_order.hpp>
#include <statistics/survival/survival_outcome.hpp>
#include <vector>

namespace tcert::statistics {

/// A pair is comparable if one row has its event while the other is at risk and outlives it (a row
/// censored at that very time does). It is concordant if the longer time has the larger predictor
/// value. Weighted, a pair counts the product of the weights of its rows and of its event's time.
struct ConcordanceCounts {
  double concordant = 0.0;
  double discordant = 0.0;
  double tied_x = 0.0;   ///< Comparable, the predictor tied.
  double tied_y = 0.0;   ///< Both have their event at the same time: not comparable.
  double tied_xy = 0.0;  ///< The same, and the predictor is tied as well.

  [[nodiscard]] double comparable() const noexcept { return concordant + discordant + tied_x; }
  ConcordanceCounts& operator+=(const ConcordanceCounts& other) noexcept;
};

/// Harrell's C: a pair tied in the predictor counts one half. NaN if no pair is comparable.
[[nodiscard]] double concordance_index(const ConcordanceCounts& counts) noexcept;

/// What a pair counts by the time of its event; survival's `timewt` with its name there. With S the
/// Kaplan-Meier curve, G that of censoring, both just before the time, and n the weight at risk.
enum class PairWeight : std::uint8_t {
  equal,                      ///< "n": every pair the same, Harrell's C.
  survival,                   ///< "S": W S / n, W the weight of all rows of the stratum.
  survival_by_censoring,      ///< "S/G": W S / (G n). Not for left-truncated rows.
  inverse_censoring_squared,  ///< "n/G2": 1 / G^2, Uno's. Not for left-truncated rows.
  inverse_at_risk,            ///< "I": 1 / n.
};

/// The rows that predictors are scored on, in time order.
struct ConcordanceRows {
  const TimeOrder* order = nullptr;  ///< Groups are the strata; only rows of one are compared.
  const SurvivalOutcome* outcome = nullptr;
  std::span<const double> weight;  ///< Case weights; empty for 1 each.
  PairWeight pair_weight = PairWeight::equal;
  double last_event = std::numeric_limits<double>::infinity();  ///< Later events count nothing.
};

/// Weight of the comparable pairs that a row is part of, its own weight left out.
struct RowPairs {
  double net = 0.0;         ///< Concordant minus discordant.
  double comparable = 0.0;  ///< Concordant, discordant and tied in the predictor.
};

struct ConcordancePairs {
  std::vector<ConcordanceCounts> by_stratum;
  std::vector<RowPairs> rows;
  /// Variance of the score of a Cox model on the predictor's ranks, which vanishes at C = 1/2:
  /// survival's `cvar` is it over 4 comparable^2.
  double score_variance = 0.0;

  [[nodiscard]] ConcordanceCounts total() const noexcept;
};

/// `larger` is the predictor, larger values going with longer times; it may hold infinities.
/// Whole weights give exact counts while below 2^53. O(n log n) for any ties, (start, stop] data
/// and strata included; the same for any number of threads.
/// \throws std::invalid_argument if a value is NaN, lengths differ or the pair weight is one that
/// left-truncated rows do not have.
[[nodiscard]] ConcordancePairs concordance_pairs(const ConcordanceRows& rows,
                                                 std::span<const double> larger);

}  // namespace tcert::statistics
