#pragma once
/// \file
/// The times of an H1 panel: censored when trials fail, and with failures at risk to the limit.

#include <cstddef>
#include <vector>

#include "analysis/study/h1/panel_data.hpp"

namespace tcert::study {

/// Whether two times are one: but for rounding, as `round_times` has it, unless every time is left
/// as it is.
[[nodiscard]] bool is_same(double at, double time, const H1Options& options);

/// Whether `time` is not after `at`.
[[nodiscard]] bool is_by(double at, double time, const H1Options& options);

/// Fills the outcomes of `data` from the times of `rows` of the table, counts what the limit cuts,
/// and says what is odd about them; without one that is above the earliest, the panel has no times.
/// \throws FormulaError if the limit lies before the times begin.
void add_times(const std::vector<double>& time,
               const std::vector<std::size_t>& rows,
               const H1Options& options,
               H1Panel& panel,
               H1Data& data);

}  // namespace tcert::study
