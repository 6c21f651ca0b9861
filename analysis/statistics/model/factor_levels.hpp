#pragma once
/// \file
/// Factors made of numbers, of other factors, and of some of their rows.

#include <cstddef>
#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// Levels by value; numbers that print alike are one, as in R's factor(). O(rows log rows).
[[nodiscard]] table::Factor levels_by_value(const std::vector<double>& numbers);

/// The levels FALSE and TRUE that occur.
[[nodiscard]] table::Factor levels_of_truth(const std::vector<double>& numbers);

/// Makes `level` the first one. \throws FormulaError, which names `column`, if there is none such.
void put_first(table::Factor& factor, const std::string& level, const std::string& column);

/// Puts the factor's own name before its levels: "sex=male".
void name_levels(table::Factor& factor, const std::string& name);

/// The cross of several factors, the first varying slowest, only levels that occur; a row where one
/// is missing is missing. Level names are joined by `separator`.
[[nodiscard]] table::Factor crossed(const std::vector<table::Factor>& factors,
                                    const std::string& separator);

/// The factor on these rows, without the levels that no longer occur.
[[nodiscard]] table::Factor on_rows(const table::Factor& factor,
                                    const std::vector<std::size_t>& rows);

}  // namespace tcert::statistics
