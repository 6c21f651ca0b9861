#pragma once
/// \file
/// An exploration as tables: one row a step, and its way.

#include <optional>
#include <string>
#include <terrain/explore.hpp>
#include <vector>

#include "datasets/terrain_file.hpp"
#include "reports/table.hpp"

namespace tcert {

/// One row a step, row 0 the state after the first batch: where was measured (x counts the lines of
/// the terrain, y its columns) and what; |S_t| and |G_t|; the cell chosen next, empty if there is
/// none, and u_t - l_t there; the widest path over S_t of l_t - h from start to goal, missing until
/// they are joined; the Lipschitz constant in use; the way so far; cells of S_t whose true value is
/// below the threshold, and steps onto such cells.
[[nodiscard]] Table explore_table(const terrain::ExploreResult& result,
                                  const std::optional<SyntheticLabel>& synthetic);

/// A row of what a robot is told that is not simulated: the columns of explore_table() but those of
/// the terrain itself; `way`, places "x y" with ; between, from where it stands to next or the
/// goal; `end`, empty while it goes on.
struct LiveRow {
  terrain::ExploreStep step;
  std::vector<terrain::Position> way;
  std::optional<terrain::End> end;
};
[[nodiscard]] Table live_table(const std::vector<LiveRow>& rows,
                               const std::optional<SyntheticLabel>& synthetic);

/// The positions the robot went through, in order: x, y; with a map also where they lie on it.
[[nodiscard]] Table path_table(const std::vector<terrain::Position>& path,
                               const std::optional<SyntheticLabel>& synthetic,
                               const std::optional<MapFrame>& map);

/// A measurement, and whether the robot stood there and planned next.
struct TakenMeasurement {
  terrain::Measurement measurement;
  bool plan = false;
};

/// What was measured, in order, that of earlier runs among it: x, y, value, plan (0 or 1).
[[nodiscard]] Table measurement_table(const std::vector<TakenMeasurement>& measurements,
                                      const std::optional<SyntheticLabel>& synthetic);

}  // namespace tcert
