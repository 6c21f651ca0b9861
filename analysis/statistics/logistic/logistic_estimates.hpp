#pragma once
/// \file
/// Estimates of logistic coefficients with their errors, or that they are not to be had. Internal
/// to logistic.cpp and the mixed model.

#include <cstddef>
#include <statistics/logistic/logistic.hpp>
#include <statistics/logistic/logistic_problem.hpp>
#include <vector>

namespace tcert::statistics {

/// Of a column in units in which neither number is extreme; `unit` is one of them in the column's.
void set_estimate(
    LogisticCoefficient& coefficient, double scaled, double variance, double unit, double level);

/// Says that the estimate has run away, in place of it.
void withhold_estimate(double estimate,
                       double standard_error,
                       LogisticCoefficient& coefficient,
                       Conditions& conditions);

/// Estimates of the problem that was solved; `names[k]` is the input's column of its column k.
void add_estimates(const LogisticInput& input,
                   const LogisticProblem& problem,
                   const NewtonResult& newton,
                   const std::vector<std::size_t>& names,
                   LogisticFit& fit);

}  // namespace tcert::statistics
