#pragma once
/// \file
/// Where a group's intercept is most likely, and what its derivatives need there. Internal to
/// intercept_likelihood.cpp.

#include <statistics/glmm/intercept_group.hpp>

namespace tcert::statistics {

inline constexpr double kLargestGroupEta = 300.0;

/// Sums over the rows at one u.
struct RowSums {
  double residual = 0.0;
  double w0 = 0.0;
  double w1 = 0.0;
  double w2 = 0.0;
};

/// Everything that the derivatives need of the mode.
struct InterceptMode {
  double u = 0.0;
  double h = 1.0;
  double s = 1.0;
  RowSums sums;
};

/// Newton's method on f_u, which falls strictly, within the bracket that its signs leave. `mode`
/// holds a guess of u0 and gets u0. False if a linear predictor exceeds 300. O(rows) an iteration.
[[nodiscard]] bool find_mode(const InterceptGroup& group, double theta, double& mode);

/// At `u`; sets w0, w1 and w2 of the scratch. O(rows).
[[nodiscard]] InterceptMode at_mode(const InterceptGroup& group,
                                    double theta,
                                    double u,
                                    InterceptScratch& scratch);

/// -f''(u) at `u`. O(rows).
[[nodiscard]] double intercept_curvature(const InterceptGroup& group, double theta, double u);

}  // namespace tcert::statistics
