#pragma once
/// \file
/// An interval estimate.

namespace tcert::statistics {

struct Interval {
  double low = 0.0;
  double high = 0.0;
  double level = 0.95;  ///< Nominal coverage, in (0, 1).
};

}  // namespace tcert::statistics
