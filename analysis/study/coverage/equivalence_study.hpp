#pragma once
// How often equivalence and difference of AUCs between lightings are found, on simulated studies
// whose truth is known.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::study::coverage {

inline constexpr std::size_t kLightings = 3;

/// Trials of days, as many in each of three lightings on every day. A latent ability L of a trial
/// decides its outcome as in `Scenario`; the predictor sees it as x = r L + sqrt(1 - r^2) N with a
/// correlation r of its lighting. L and N have the within-day correlation `icc`, the same day over
/// all lightings.
struct LightingScenario {
  std::string name;
  std::size_t days = 22;
  std::size_t trials_per_lighting = 10;  ///< Of a day.
  double icc = 0.0;
  double difference = 0.0;  ///< AUC of the first two lightings less that of the third.
  double margin = 0.05;
};

struct LightingStudy {
  std::vector<double> predictor;
  std::vector<std::uint8_t> success;
  std::vector<std::uint32_t> day;
  table::Factor lighting;
};

/// The correlation at which `true_auc` is `auc`. \pre 0.5 <= auc < 0.95.
double correlation_of(double auc);

/// Data set number `index`; `correlation` is r of each lighting.
LightingStudy simulate(const LightingScenario& scenario,
                       const std::array<double, kLightings>& correlation,
                       std::uint64_t seed,
                       std::uint32_t stream,
                       std::uint64_t index);

struct EquivalenceRates {
  std::string scenario;
  std::size_t tested = 0;          ///< Data sets with an AUC and a variance in every lighting.
  double equivalent = 0.0;         ///< Share whose pairs all pass the two one-sided tests at 5 %.
  double one_pair = 0.0;           ///< Share where the pair first, third passes.
  double different = 0.0;          ///< Share where the Wald test of equality has p < 0.05.
  double mean_error = 0.0;         ///< Standard error of the pair first, third.
  double true_error = 0.0;         ///< Standard deviation of its difference over the data sets.
  double mean_range = 0.0;         ///< Largest less smallest AUC.
  double mean_power_margin = 0.0;  ///< Margin with 80 % power, as printed.
};

/// Within-day correlations of 0, 0.2, 0.5, margins of 0.05, 0.22, 0.27, and lightings that are
/// alike, half a margin and a margin apart.
[[nodiscard]] std::vector<LightingScenario> equivalence_scenarios();

/// All data sets of a scenario, 0.76 the AUC of the better lightings. `stream` must differ between
/// scenarios. The same numbers for any number of threads.
EquivalenceRates run_equivalence(const LightingScenario& scenario,
                                 std::uint32_t stream,
                                 std::size_t data_sets,
                                 std::uint64_t seed = 1);

}  // namespace tcert::study::coverage
