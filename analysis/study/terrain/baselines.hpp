#pragma once
/// \file
/// What the method is compared with: a walk straight to the goal, and a sparse Gaussian process
/// under a sampling planner.

#include <cstddef>
#include <functional>
#include <terrain/explore.hpp>
#include <vector>

namespace tcert::terrain {

struct BaselineResult {
  bool reached = false;
  std::size_t unsafe_visits = 0;  ///< Steps onto cells below the threshold: failures.
  std::size_t samples = 0;        ///< Values of the terrain that were used.
  std::size_t plans = 0;
  double length = 0.0;  ///< Of the way, cells.
  std::vector<Position> path;
};

/// The reactive baseline: along the straight line, round physical obstacles by the shortest way,
/// blind to what the ground is like.
[[nodiscard]] BaselineResult straight_walk(
    const Terrain& terrain, const CellSet& blocked, double threshold, Cell start, Cell goal);

struct SparseRrtOptions {
  GpPrior prior{1000.0, 90000.0, 70.0, 100.0};
  double inducing_spacing = 35.0;  ///< Cells between inducing points, on a lattice.
  double sensor_range = 60.0;      ///< The terrain is seen so far, from afar.
  int samples_per_plan = 40;
  int nodes = 800;                  ///< Of a tree.
  double extend = 15.0;             ///< Longest edge, cells.
  double rewire = 35.0;             ///< Radius within which parents are changed, cells.
  double risk_weight = 10.0;        ///< Of the expected shortfall below the threshold, per 100.
  double uncertainty_weight = 0.5;  ///< Of a standard deviation, per 100.
  double move = 30.0;               ///< Cells gone before the next plan.
  int max_plans = 200;
};

/// Global planning over a terrain that is seen from afar: a sparse process (deterministic training
/// conditional, inducing points on a lattice) gives mean and deviation, which raise the cost of an
/// edge but forbid nothing; RRT* to the goal, part of the way, and again. `uniform` gives draws in
/// [0, 1).
[[nodiscard]] BaselineResult sparse_rrt_walk(const Terrain& terrain,
                                             double threshold,
                                             Cell start,
                                             Cell goal,
                                             const SparseRrtOptions& options,
                                             const std::function<double()>& uniform);

}  // namespace tcert::terrain
