#pragma once
// How often equivalence and difference of AUCs between lightings are found, on simulated studies
// whose truth is known.

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <table/factor.hpp>
#include <table/row_text.hpp>
#include <vector>

#include "datasets/corpus/design.hpp"

namespace tcert::study::coverage {

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

/// What one data set gives. Nothing without an AUC and a variance in every lighting.
struct EquivalenceFound {
  bool equivalent = false;
  bool one_pair = false;
  bool different = false;
  double error = 0.0;
  double range = 0.0;
  double power_margin = 0.0;
  double difference = 0.0;  ///< Of the pair first, third.
};

void row_cells(auto& row, table::Is<EquivalenceFound> auto& found) {
  row(found.equivalent, found.one_pair, found.different);
  row(found.error, found.range, found.power_margin, found.difference);
}

struct EquivalenceRates {
  std::string scenario;
  std::size_t tested =
      0;  ///< Data sets with an AUC, a variance and enough outcomes in every lighting.
  double equivalent = 0.0;         ///< Share whose pairs all pass the two one-sided tests at 5 %.
  double one_pair = 0.0;           ///< Share where the pair first, third passes.
  double different = 0.0;          ///< Share where the Wald test of equality has p < 0.05.
  double mean_error = 0.0;         ///< Standard error of the pair first, third.
  double true_error = 0.0;         ///< Standard deviation of its difference over the data sets.
  double mean_range = 0.0;         ///< Largest less smallest AUC.
  double mean_power_margin = 0.0;  ///< Margin with 80 % power, as printed.
};

/// Within-day correlations of 0, 0.2, 0.5, margins of 0.05, 0.22, 0.27, and lightings that are
/// alike, half a margin and a margin apart, on 22 days; and lightings that are alike on 6, 12
/// and 40.
[[nodiscard]] std::vector<LightingScenario> equivalence_scenarios();

/// Data sets of a scenario, 0.76 the AUC of the better lightings. `stream` must differ between
/// scenarios.
class EquivalenceSets {
 public:
  EquivalenceSets(LightingScenario scenario, std::uint32_t stream, std::uint64_t seed);

  /// Data set number `index`. Thread-safe.
  [[nodiscard]] std::optional<EquivalenceFound> operator()(std::uint64_t index) const;

 private:
  LightingScenario scenario_;
  std::uint32_t stream_;
  std::uint64_t seed_;
  // A third of a second, which whoever makes no data set of it need not wait for.
  mutable std::once_flag is_known_;
  mutable std::array<double, kLightings> correlation_{};
};

/// What the data sets of a scenario come to, one after the other.
class EquivalenceTally {
 public:
  void add(const std::optional<EquivalenceFound>& found);

  [[nodiscard]] EquivalenceRates rates() const;

 private:
  EquivalenceRates sums_;  ///< Of what the rates are means of.
  double sum_ = 0.0;
  double squares_ = 0.0;
};

}  // namespace tcert::study::coverage
