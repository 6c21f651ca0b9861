#pragma once
/// \file
/// How well predicted probabilities agree with outcomes. Slope, intercepts and Brier score are
/// those of R's `rms::val.prob`, the test that of Hosmer and Lemeshow. Apparent probabilities, of a
/// fit to the same rows, are always too good: give out-of-fold ones.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <statistics/basics/chi_square.hpp>
#include <statistics/basics/condition.hpp>
#include <statistics/basics/wald_estimate.hpp>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

struct CalibrationOptions {
  double level = 0.95;
  std::size_t bins = 10;  ///< Of the curve, the Brier score's parts and the test.
  std::string column;     ///< The probabilities' name in conditions.
  std::function<std::string(std::size_t)> place;  ///< Row i in words; empty: "row i + 1".
};

/// Trials whose probability lies between two cuts.
struct CalibrationBin {
  double low = 0.0;   ///< Excluded, but in the first bin.
  double high = 0.0;  ///< Included.
  std::size_t trials = 0;
  std::size_t events = 0;
  std::size_t clusters = 0;        ///< That have trials in it; 0 if there are none.
  double predicted = 0.0;          ///< Mean probability.
  double observed = 0.0;           ///< events / trials.
  std::optional<Interval> wilson;  ///< Of `observed`, as if its trials were independent.
};

/// mean (p - y)^2 = reliability - resolution + uncertainty + within_variance - within_covariance,
/// exactly: the first three are Murphy's (1973) on the bins' mean probabilities; what a bin's mean
/// leaves out is kept in two terms of their own (Stephenson, Coelho and Jolliffe 2008).
struct BrierParts {
  double score = 0.0;
  double reliability = 0.0;        ///< sum n_k (p_k - y_k)^2 / n: 0 is best.
  double resolution = 0.0;         ///< sum n_k (y_k - y)^2 / n: large is best.
  double uncertainty = 0.0;        ///< y (1 - y): that of the data.
  double within_variance = 0.0;    ///< sum (p - p_k)^2 / n.
  double within_covariance = 0.0;  ///< 2 sum (p - p_k) (y - y_k) / n.
};

struct ModelCalibration {
  std::size_t rows = 0;  ///< With a probability and an outcome.
  std::size_t events = 0;
  std::size_t missing = 0;   ///< Rows left out.
  std::size_t clusters = 0;  ///< 0 if rows are taken as independent.
  /// Of the recalibration; the standard errors are cluster-robust where there are clusters.
  WaldEstimate slope;         ///< b of logit Pr(y = 1) = a + b logit p; ideal 1.
  WaldEstimate intercept;     ///< a of the same; ideal 0.
  WaldEstimate in_the_large;  ///< The intercept where b is held at 1; ideal 0.
  double observed = 0.0;      ///< Events.
  double expected = 0.0;      ///< Sum of the probabilities.
  std::optional<double> expected_to_observed;
  std::optional<BrierParts> brier;
  std::optional<ChiSquareTest> hosmer_lemeshow;  ///< On bins - 2 degrees of freedom.
  std::vector<CalibrationBin> bins;
  Conditions conditions;
};

/// `outcome` holds 0, 1 or NaN, `probability` what was predicted of 1, NaN where nothing was;
/// `cluster` may be null. Bins are cut at the type-7 quantiles of the probabilities; ties may leave
/// fewer (few_bins). The recalibration has no finite slope where the probabilities separate the
/// outcomes (complete_separation, quasi_separation) or are all equal (constant_column).
///
/// Conditions: no_rows, no_prediction (no row has a probability), bad_probability (below 0 or above
/// 1; errors); one_class, certain_probability (one of exactly 0 or 1): only the Brier score, the
/// bins and E:O. \throws std::invalid_argument if lengths differ, an outcome is another number, the
/// level is not in (0, 1) or there are fewer than 3 bins. O(n log n).
[[nodiscard]] ModelCalibration calibration(std::span<const double> outcome,
                                           std::span<const double> probability,
                                           const table::Factor* cluster = nullptr,
                                           const CalibrationOptions& options = {});

}  // namespace tcert::statistics
