#pragma once
/// \file
/// A unicycle with a round body that follows its legs, slides along walls and wedges in gaps.

#include <cstdint>
#include <table/random.hpp>
#include <tcert/region.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/corpus/policy.hpp"
#include "datasets/corpus/route.hpp"
#include "datasets/corpus/wall_index.hpp"

namespace tcert {

inline constexpr double kDriveStep = 0.05;  ///< Integration step, s.

struct DrivePlan {
  Pose start;
  std::vector<Leg> legs;
  Region goal;
  Policy policy;
  /// 0: caution is the same at every contact; 1: it deepens with a tentacle's bend. In between:
  /// mixed.
  double graded_caution = 1.0;
  double body_radius_m = 0.225;
  EndReason when_stuck = EndReason::wedged;  ///< wedged, collision, or timeout: try again.
  double time_limit_s = 180.0;
};

/// True motion at multiples of kDriveStep, and what was commanded then.
struct Drive {
  std::vector<Pose> poses;
  std::vector<double> speed_cmd_mps;
  std::vector<double> yaw_rate_cmd_rps;
  EndReason end_reason = EndReason::unknown;
  double time_s = 0.0;      ///< Of the first entry into G, or of the end.
  double distance_m = 0.0;  ///< Until then.
};

/// Drives until the robot has stood in G for 1 s, has pushed in vain for some seconds (wedged), has
/// been stopped after a push (collision), or has run out of time trying again and again.
[[nodiscard]] Drive drive(const DrivePlan& plan,
                          const WallIndex& walls,
                          table::RandomStream random);

}  // namespace tcert
