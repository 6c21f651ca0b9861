#pragma once
/// \file
/// What the logistic fits ask of their input before they start.

#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_problem.hpp>

namespace tcert::statistics {

/// \throws std::invalid_argument if lengths differ, successes lie outside [0, trials] or `level`
/// outside (0, 1).
void check_lengths(const LogisticInput& input, double level);

/// Values that no arithmetic can use: infinite_value, bad_weight, errors.
void add_value_conditions(const LogisticInput& input, Conditions& conditions);

/// constant_column or collinear_column, warnings, for each column that the basis left out.
void add_rank_conditions(const LogisticInput& input,
                         const LogisticProblem& problem,
                         Conditions& conditions);

[[nodiscard]] bool has_intercept(const LogisticInput& input);

}  // namespace tcert::statistics
