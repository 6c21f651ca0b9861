#pragma once
// How often intervals of AUCs and Cs cover the truth, on simulated studies whose truth is known.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/interval_row.hpp>
#include <string>
#include <table/row_text.hpp>
#include <vector>

namespace tcert::study::coverage {

/// How often one printed number missed what is true.
struct Missed {
  std::size_t sets = 0;     ///< That have it.
  std::size_t without = 0;  ///< Withheld, or not there.
  double missed = 0.0;      ///< Share; NaN of none.
  double monte_carlo_se = 0.0;
};

/// Of number `k` of each set, whose `of[k]` says whether it missed, or nothing.
template <class Set>
[[nodiscard]] Missed count_missed(const std::vector<Set>& sets, std::size_t k) {
  Missed rate;
  for (const Set& set : sets) {
    (set.of[k] ? rate.sets : rate.without) += 1;
    rate.missed += set.of[k].value_or(false) ? 1.0 : 0.0;
  }
  const auto count = static_cast<double>(rate.sets);
  rate.missed /= count;
  rate.monte_carlo_se = std::sqrt(rate.missed * (1.0 - rate.missed) / count);
  return rate;
}

/// Trials of days. A latent ability L of a trial, standard normal, decides its outcome: it fails
/// below a threshold that 77 of 660 trials miss. Two predictors see it through noise:
/// x_k = r_k L + sqrt(1 - r_k^2) N_k. L and every N_k have the within-day correlation `icc`, so
/// days differ in their failures and in their predictors. A success takes the less time the abler
/// the trial is; a failure is censored after all of them.
struct Scenario {
  std::string name;
  std::size_t days = 22;
  std::size_t trials_per_day = 30;
  double icc = 0.0;
};

inline constexpr double kFailureShare = 77.0 / 660.0;
inline constexpr double kFirstCorrelation = 0.5;
inline constexpr double kSecondCorrelation = 0.3;

struct Study {
  std::vector<double> first;
  std::vector<double> second;
  std::vector<std::uint8_t> success;
  std::vector<double> time;
  std::vector<std::uint32_t> day;
};

/// Data set number `index` of a scenario, keyed by (seed, stream, index).
Study simulate(const Scenario& scenario,
               std::uint64_t seed,
               std::uint32_t stream,
               std::uint64_t index);

/// Pr(x of a success > x of a failure) for trials of different days, by quadrature: given both
/// abilities the difference of the predictors is normal.
double true_auc(double correlation);

/// Pr(x of the abler > x of the other) for trials of different days of which the abler succeeds.
double true_c(double correlation);

struct Options {
  std::size_t data_sets = 2000;
  std::size_t replicates = 1999;
  std::uint64_t seed = 1;
  double level = 0.95;
};

/// One interval method on one quantity.
struct Coverage {
  std::string scenario;
  std::string quantity;  ///< "auc", "c" of the first predictor; "delta_auc", "delta_c" over the
                         ///< second.
  std::string method;
  double truth = 0.0;
  double mean_estimate = 0.0;  ///< Over the data sets: its distance to the truth is a bias.
  std::size_t intervals = 0;   ///< Data sets that had one.
  std::size_t missing = 0;
  std::size_t withheld = 0;     ///< Data sets with too few of an outcome for intervals.
  double covered = 0.0;         ///< Share of the intervals that cover the truth.
  double monte_carlo_se = 0.0;  ///< Of that share.
  double mean_width = 0.0;
};

inline constexpr std::size_t kMethods = 6;
inline constexpr std::size_t kQuantities = 4;

/// Fewer than `kTooFewOutcomes` of an outcome: the tables of hypotheses then print no interval.
[[nodiscard]] bool is_withheld(const Study& study);

/// Of one data set: the estimate of every quantity, and its intervals by every method.
struct Intervals {
  bool withheld = false;  ///< The rest is then empty.
  std::array<std::array<std::optional<statistics::Interval>, kMethods>, kQuantities> by_quantity;
  std::array<double, kQuantities> estimate{};
};

void row_cells(auto& row, table::Is<Intervals> auto& set) {
  row(set.withheld);
  for (std::size_t quantity = 0; quantity < kQuantities; ++quantity) {
    row(set.estimate[quantity]);
    for (auto& interval : set.by_quantity[quantity]) {
      row(interval);
    }
  }
}

/// Data set number `index` of a scenario. `stream` must differ between scenarios.
[[nodiscard]] Intervals intervals_of(const Scenario& scenario,
                                     std::uint32_t stream,
                                     const Options& options,
                                     std::uint64_t index);

/// What the data sets of a scenario come to, one after the other.
class CoverageTally {
 public:
  explicit CoverageTally(const std::string& scenario);

  void add(const Intervals& set);

  /// A row a quantity and method.
  [[nodiscard]] std::vector<Coverage> rows() const;

 private:
  std::vector<Coverage> sums_;  ///< Of what the rows have means of.
};

/// 6, 12, 22 and 40 days of 30 trials with within-day correlations of 0, 0.2 and 0.5.
[[nodiscard]] std::vector<Scenario> coverage_scenarios();

}  // namespace tcert::study::coverage
