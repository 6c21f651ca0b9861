#pragma once
/// \file
/// One max-min search over poses.

#include <cstdint>
#include <vector>

#include "analysis/study/truth/arc.hpp"
#include "analysis/study/truth/clearance_table.hpp"
#include "analysis/study/truth/slack.hpp"
#include "datasets/world.hpp"

namespace tcert::study {

/// What a search is asked.
struct CurvatureQuery {
  SlackConvention convention = SlackConvention::width;
  double body_width_m = 0.0;
  double cell_m = 0.1;
  int headings = 48;
  double above_m = 0.0;         ///< Paths of no more than this are of no interest; at least the
                                ///< slack of clearance 0.
  double enough_m = 0.0;        ///< Values above this count as this.
  std::vector<double> radii_m;  ///< Of the arcs, both ways; straight ones besides.
  std::vector<double> worth_m;  ///< r - R_min of each.
};

/// Arcs from S to G, the best path of the search; empty if none is above `above_m`. `steps` orders
/// poses of the same value: fewer to go first.
/// \throws std::invalid_argument if the lattice would have more than 2^25 poses, 28 bytes each
/// when all are seen.
[[nodiscard]] std::vector<Arc> search_path(const World& world,
                                           const ClearanceTable& table,
                                           const std::vector<std::uint32_t>& steps,
                                           const CurvatureQuery& query);

}  // namespace tcert::study
