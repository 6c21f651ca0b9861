#pragma once
/// \file
/// Columns of a Cox model that have an estimate of their own, and those that have not. Internal to
/// cox_newton.cpp.

#include <statistics/cox/cox_newton.hpp>
#include <vector>

namespace tcert::statistics {

/// Information left in the limit, of that at 0.
inline constexpr double kLimitTolerance = 1e-6;

/// By the information at beta = 0: estimated, constant or collinear.
[[nodiscard]] std::vector<ColumnState> column_states(const CoxRows& rows,
                                                     const CoxDerivatives& null,
                                                     double tolerance);

}  // namespace tcert::statistics
