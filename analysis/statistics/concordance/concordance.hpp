#pragma once
/// \file
/// Harrell's C of one or more predictors on the same rows, with the variance by the infinitesimal
/// jackknife (clustered or not), and the differences between them. Checked against
/// `survival::concordance`, the direction given and never taken from the data.

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/interval.hpp>
#include <statistics/concordance/concordance_pairs.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// What a larger value of a predictor goes with. Fixed beforehand, never from the data. R's
/// `concordance(y ~ x)` takes `longer_time`, its `reverse = TRUE` and risk scores `shorter_time`.
enum class LargerMeans : std::uint8_t { longer_time, shorter_time };

struct Predictor {
  std::string name;
  std::span<const double> values;  ///< May hold infinities; NaN is missing.
  LargerMeans larger = LargerMeans::longer_time;
};

struct ConcordanceOptions {
  std::span<const double> weights;        ///< Case weights >= 0, finite; empty for 1 each.
  const table::Factor* strata = nullptr;  ///< Only rows of the same stratum are compared.
  const table::Factor* cluster =
      nullptr;  ///< Rows whose dfbetas are added before they are squared.
  PairWeight pair_weight = PairWeight::equal;
  std::optional<double> earliest;  ///< R's ymin: earlier times count as this one.
  std::optional<double> latest;    ///< R's ymax: events after it count nothing.
  double level = 0.95;
};

struct ConcordanceEstimate {
  std::string name;
  std::optional<double> c;
  std::optional<double> variance;  ///< Sum of the squared dfbetas of the rows or clusters.
  std::optional<double> std_error;
  std::optional<double>
      null_variance;                 ///< R's cvar: from the Cox score at C = 1/2, never clustered.
  std::optional<Interval> interval;  ///< Wald on C, clipped to [0, 1].
  ConcordanceCounts counts;          ///< In the predictor's direction.
  std::vector<ConcordanceCounts> by_stratum;  ///< One per level of the strata.
  std::vector<double> dfbeta;  ///< Per complete row, its weight included; empty without C.
  Conditions conditions;
};

/// First minus second predictor.
struct ConcordanceDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  std::optional<double> difference;
  std::optional<double> variance;
  std::optional<double> std_error;
  std::optional<Interval> interval;  ///< Wald, not clipped.
  std::optional<double> z;
  std::optional<double> p_value;  ///< Two-sided, normal.
  Conditions conditions;
};

struct ConcordanceResult {
  std::size_t n = 0;              ///< Complete rows.
  std::size_t events = 0;         ///< Among the complete rows.
  std::size_t clusters = 0;       ///< Among the complete rows; 0 if there is no cluster.
  std::vector<std::size_t> rows;  ///< Those with every predictor known; empty if all are.
  std::size_t missing = 0;        ///< Rows left out.
  std::vector<ConcordanceEstimate> estimates;  ///< One per predictor.
  Eigen::MatrixXd covariance;  ///< predictors x predictors; NaN where there is no variance.
  std::vector<ConcordanceDifference> differences;  ///< Every pair (i, j), i < j.
  Conditions conditions;                           ///< Of the rows, the same for every predictor.
};

/// `outcome` has rounded times; a start that all rows share (a landmark) is no truncation. A time
/// tie is broken as R does: an event precedes a censoring at its time. O(n log n) per predictor.
/// With one event in a stratum R's `concordance` falls back to equal pair weights; this does not.
/// \throws std::invalid_argument if lengths differ, a factor has missing codes, a weight, time or
/// event is out of range, a censored row is earlier than `earliest`, the pair weight is one that
/// left-truncated rows do not have, or `level` is not in (0, 1).
[[nodiscard]] ConcordanceResult concordance(const SurvivalOutcome& outcome,
                                            std::span<const Predictor> predictors,
                                            const ConcordanceOptions& options = {});

/// A plain number as the outcome, as R's `concordance(y ~ x)` takes it: every row has its event at
/// its value. For 0/1 outcomes C is the AUC. Values are still to be rounded as times are.
[[nodiscard]] SurvivalOutcome uncensored(std::span<const double> values);

}  // namespace tcert::statistics
