#pragma once
// How often the intervals and tests that `hypotheses h3` prints miss the truth, on simulated
// replays.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <table/row_text.hpp>
#include <vector>

#include "analysis/study/coverage/coverage_study.hpp"
#include "analysis/study/h3/replay_rows.hpp"

namespace tcert::study::coverage {

/// Days of trials of a gated algorithm and of a baseline, a third of either in each of three
/// lightings. Log times have a deviation of 0.3, failures and losses a latent ability each, and
/// all of them the within-day correlation `icc`. Law `bold` gains speed at both of its betas alike
/// and loses, of the successes, so many that the margin of all trials is just reached; law `idle`
/// gains nothing and loses nothing: neither holds, in any lighting.
struct AdvanceScenario {
  std::string name;
  std::size_t days = 22;
  std::size_t trials_per_lighting = 3;  ///< Of a day and algorithm.
  double icc = 0.0;
};

/// An interval at a nominal 95 %, or a test at 5 % of what is true.
struct AdvancePrinted {
  const char* name;
  bool is_test;
};

inline constexpr std::array<AdvancePrinted, 11> kAdvancePrinted{{
    {"rate of advance", false},
    {"gap", false},
    {"gain", false},
    {"gain, one lighting", false},
    {"share of the gap", false},
    {"gain, beta by folds", false},
    {"share of the gap, beta by folds", false},
    {"no gain", true},
    {"non-inferior", true},
    {"non-inferior, trials independent", true},
    {"any law in any lighting, Holm", true},
}};

struct AdvanceMisses {
  std::array<std::optional<bool>, kAdvancePrinted.size()> of;
};

void row_cells(auto& row, table::Is<AdvanceMisses> auto& set) {
  for (auto& one : set.of) {
    row(one);
  }
}

/// Data set number `index`, a row a trial and case.
[[nodiscard]] ReplayRows simulate_replays(const AdvanceScenario& scenario,
                                          std::uint64_t seed,
                                          std::uint32_t stream,
                                          std::uint64_t index);

[[nodiscard]] AdvanceMisses advance_misses_of(const AdvanceScenario& scenario,
                                              std::uint32_t stream,
                                              const Options& options,
                                              std::uint64_t index);

struct AdvanceRate : Missed {
  AdvanceScenario scenario;
  AdvancePrinted printed;
};

[[nodiscard]] std::vector<AdvanceRate> advance_rates(const AdvanceScenario& scenario,
                                                     const std::vector<AdvanceMisses>& sets);

/// Days and correlations as of `coverage_scenarios()`.
[[nodiscard]] std::vector<AdvanceScenario> advance_scenarios();

}  // namespace tcert::study::coverage
