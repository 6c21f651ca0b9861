#pragma once
/// \file
/// One trial as the page's viewer reads it: its series, fewer ticks of it, and its map.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/world.hpp"
#include "reports/html/page_series.hpp"

namespace tcert {

/// How ticks were chosen, for the reader.
[[nodiscard]] std::string_view decimation_rule() noexcept;

/// An edge of the corridor graph, drawn straight between its nodes.
struct MapEdge {
  Point a;
  Point b;
  double margin_m = 0.0;
};

struct TrialMap {
  std::vector<MapEdge> edges;
  std::optional<Point> bottleneck;
  std::vector<Point> witness;  ///< Along the path of the witness; none if there is none.
  std::optional<Point> witness_bottleneck;
  bool felt = false;  ///< Show what the rays proved free on either side, where no world is known.
  std::string note;   ///< What is not shown, and why; or empty.
};

/// packed() JSON of a trial, at most `limit` ticks of it (kept_ticks()). The place of issuance is
/// the first tick with issued = 1; the extreme ticks of every column are exact to 1/scale. \pre
/// `series` is of read_page_series() and has a row.
[[nodiscard]] std::string trial_block(const table::NumberTable& series,
                                      const TrialMap& map,
                                      const std::string& facts,
                                      std::size_t limit);

/// packed() JSON of a world: what is not free, and S and G.
[[nodiscard]] std::string world_block(const World& world);

}  // namespace tcert
