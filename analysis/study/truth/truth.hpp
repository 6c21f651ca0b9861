#pragma once
/// \file
/// T(E; A) of a known world, as an interval.

#include <cstddef>
#include <tcert/robot.hpp>
#include <vector>

#include "analysis/study/truth/arc.hpp"
#include "analysis/study/truth/clearance_value.hpp"
#include "analysis/study/truth/slack.hpp"
#include "datasets/world.hpp"

namespace tcert::study {

struct TruthOptions {
  SlackConvention convention = SlackConvention::width;
  double step_m = 0.02;   ///< Of the grid, where the clearance has no exact answer.
  bool curvature = true;  ///< Search with the turning limit; else T is the clearance-only value.
  double path_cell_m = 0.01;  ///< As of CurvatureOptions.
  double turn_cell_m = 0.0;   ///< Of turning_upper(), which lowers upper_m; 0: it is not asked.
};

/// [lower_m, upper_m] holds T(E; A) = sup over paths from S to G of min(clearance slack, curvature
/// slack). Minus infinity: no path, or none found (lower), none at all (upper).
struct Truth {
  double lower_m = ClearanceValue::kNoPath;
  double upper_m = ClearanceValue::kNoPath;
  bool exact_clearance = false;  ///< Discs only: upper_m is the exact clearance-only value.
  ClearanceValue clearance;
  std::vector<Arc> path;  ///< That attains lower_m, if the search with curvature found one.
};

/// Clearance-only value, exact where the world is a field of discs.
[[nodiscard]] ClearanceValue clearance_value(const World& world, double step_m);

/// T_upper: the upper end of the clearance-only value, as slack. No path is wider, whatever the
/// turning limit. \throws std::invalid_argument as clearance_value.
[[nodiscard]] double truth_upper(const World& world,
                                 const Robot& robot,
                                 const TruthOptions& options = {});

/// \throws std::invalid_argument naming the world, as clearance_value.
[[nodiscard]] Truth truth_of(const World& world,
                             const Robot& robot,
                             const TruthOptions& options = {});

}  // namespace tcert::study
