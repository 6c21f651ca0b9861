#pragma once
// How often tests of coefficients by clusters reject what is true, on simulated studies.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <table/row_text.hpp>
#include <vector>

#include "analysis/study/coverage/coverage_study.hpp"

namespace tcert::study::coverage {

/// Log odds of success and log hazard of it, per unit of the first predictor alone, and of one that
/// tells nothing beside the second.
inline constexpr std::array<const char*, 4> kCoefficients{
    "log_odds", "log_hazard", "log_odds_added", "log_hazard_added"};
/// The first is the normal distribution with an uncorrected sandwich; the others are
/// `statistics::ClusterInference`, in its order.
inline constexpr std::array<const char*, 5> kInferences{
    "normal", "cr1", "cr2", "jackknife", "wild"};

/// Of the true value, by each method; empty without one.
struct TruthTests {
  bool withheld = false;  ///< Fewer than `kTooFewOutcomes` of an outcome.
  std::array<std::array<std::optional<double>, kInferences.size()>, kCoefficients.size()> p;
};

void row_cells(auto& row, table::Is<TruthTests> auto& set) {
  row(set.withheld);
  for (auto& of_coefficient : set.p) {
    for (auto& p : of_coefficient) {
      row(p);
    }
  }
}

/// What the model of one predictor of correlation `r` estimates from ever more trials, though it
/// does not hold: the root of its expected score, by quadrature.
[[nodiscard]] double limit_log_odds(double r);
[[nodiscard]] double limit_log_hazard(double r);

/// Data set number `index` of a scenario; what is added tells nothing, and is alike within a day as
/// the others are. `stream` and the one after it must be the scenario's own.
[[nodiscard]] TruthTests truth_tests_of(const Scenario& scenario,
                                        std::uint32_t stream,
                                        const Options& options,
                                        std::uint64_t index);

struct InferenceRate {
  Scenario scenario;
  std::string coefficient;
  std::string method;
  std::size_t tests = 0;
  std::size_t missing = 0;   ///< Of the data sets that are not withheld.
  std::size_t withheld = 0;  ///< Data sets.
  double rejected = 0.0;     ///< Share with p < 1 - level: what the interval misses the truth in.
  double monte_carlo_se = 0.0;
};

/// A row a coefficient and method.
[[nodiscard]] std::vector<InferenceRate> inference_rates(const Scenario& scenario,
                                                         const std::vector<TruthTests>& sets,
                                                         double level);

}  // namespace tcert::study::coverage
