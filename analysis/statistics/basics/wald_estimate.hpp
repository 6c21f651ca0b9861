#pragma once
/// \file
/// An estimate with its standard error.

#include <optional>
#include <statistics/basics/interval.hpp>

namespace tcert::statistics {

/// What logistic fits, Firth's and recalibrations give of a coefficient; empty where it has none.
struct WaldEstimate {
  std::optional<double> estimate;
  std::optional<double> standard_error;
  std::optional<Interval> interval;  ///< Wald.
};

}  // namespace tcert::statistics
