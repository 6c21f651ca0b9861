#pragma once
/// \file
/// R's cut(): numbers into intervals.

#include <string>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// `breaks` are the ends of intervals, or one whole number of them of equal width over `known`;
/// `labels` are those of R if empty: "(1,2.5]". Outside of all intervals a number is missing.
/// `text` names the call. \throws FormulaError for fewer than two breaks that differ, or another
/// number of labels.
[[nodiscard]] table::Factor cut_into(const std::vector<double>& x,
                                     const std::vector<double>& known,
                                     std::vector<double> breaks,
                                     const std::vector<std::string>& labels,
                                     bool include_lowest,
                                     bool right,
                                     const std::string& text);

}  // namespace tcert::statistics
