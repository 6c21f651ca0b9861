#pragma once
/// \file
/// What is said of times before anything is estimated from them.

#include <functional>
#include <span>
#include <statistics/basics/condition.hpp>
#include <statistics/survival/time_rounding.hpp>
#include <string>

namespace tcert::statistics {

/// Notes: near_times if R's timefix would leave fewer times, merged_times if times were made one
/// that differ by more than the last digits of a double.
void add_rounding_conditions(const TimeRounding& rounding,
                             const std::string& column,
                             Conditions& conditions);

/// A warning, stamped_times, if all times are stamps (`are_stamps`), else
/// a warning, unlike_times, of times that are far from the others (`unlike_times`). `place(i)` says
/// where the i-th of them stands.
void add_unlike_times(std::span<const double> times,
                      const std::string& column,
                      const std::function<std::string(std::size_t)>& place,
                      Conditions& conditions);

}  // namespace tcert::statistics
