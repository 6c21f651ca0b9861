#pragma once
// How often the intervals and tests that `hypotheses h1` and `h2` print miss the truth: simulated
// tables are given to them as a user gives theirs, and their answers are read.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <table/data_table.hpp>
#include <table/row_text.hpp>
#include <vector>

#include "analysis/study/coverage/coverage_study.hpp"

namespace tcert::study::coverage {

/// A number of the tables: an interval at a nominal level, or a test at 5 % of what is true.
struct Printed {
  const char* table;
  const char* name;
  bool is_test;
  double nominal;  ///< Share that may miss.
};

inline constexpr std::array<Printed, 26> kPrinted{{
    {"h1_within", "auc_within", false, 0.05},
    {"h1_within", "auc_gain_within", false, 0.05},
    {"h1_within", "auc_gain_between", false, 0.05},
    {"h1_time_within", "c_within", false, 0.05},
    {"h1_time_within", "c_gain_within", false, 0.05},
    {"h1_time_within", "c_gain_between", false, 0.05},
    {"h1_time", "c_at_limit", false, 0.05},
    {"h1_time", "hr_censored", false, 0.05},
    {"h1_time", "hr_at_limit", false, 0.05},
    {"h1_time", "hr_stratified", false, 0.05},
    {"h1_mixed", "or_per_sd", true, 0.05},
    {"h1_log_time", "r2_gain", false, 0.05},
    {"h1_log_time", "time_ratio", true, 0.05},
    {"h2", "auc", false, 0.05},
    {"h2", "c", false, 0.05},
    {"h2", "or", false, 0.05},
    {"h2", "hr_censored", false, 0.05},
    {"h2_equality", "auc", true, 0.05},
    {"h2_equality", "c", true, 0.05},
    {"h2_pairs", "c, 90 %", false, 0.10},
    {"h2_interaction", "logistic", true, 0.05},
    {"h2_interaction", "Cox", true, 0.05},
    {"h2_interaction", "Cox, stratified", true, 0.05},
    {"h2_interaction", "logistic, mixed", true, 0.05},
    {"fit glm --contrasts", "any pair, Holm", true, 0.05},
    {"fit lmm --contrasts", "any pair, Holm", true, 0.05},
}};

/// Of one data set: whether each misses; empty where it is withheld or not there.
struct Misses {
  std::array<std::optional<bool>, kPrinted.size()> of;
};

void row_cells(auto& row, table::Is<Misses> auto& set) {
  for (auto& one : set.of) {
    row(one);
  }
}

/// Two algorithms and three lightings in turn on every day, which change nothing: within a stratum
/// and between them the truth is the same. Columns day, algorithm, lighting, success, time_s and
/// the predictors first, second and unrelated; data set number `index`. `stream` and the one after
/// it must be the scenario's own.
[[nodiscard]] table::DataTable simulated_table(const Scenario& scenario,
                                               std::uint64_t seed,
                                               std::uint32_t stream,
                                               std::uint64_t index);

/// Of log time of a success on a predictor of correlation `r`, in ever more trials: its squared
/// correlation, by quadrature.
[[nodiscard]] double limit_r2(double r);

/// `options.replicates` are those of 22 days; fewer days, which cost less and whose tails lie
/// further out, have more in proportion.
[[nodiscard]] Misses misses_of(const Scenario& scenario,
                               std::uint32_t stream,
                               const Options& options,
                               std::uint64_t index);

struct MissRate : Missed {
  Scenario scenario;
  Printed printed;
};

[[nodiscard]] std::vector<MissRate> miss_rates(const Scenario& scenario,
                                               const std::vector<Misses>& sets);

}  // namespace tcert::study::coverage
