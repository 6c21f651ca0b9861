#pragma once
/// \file
/// Lengths, slopes and places of `explore` in cells, whatever they were told in.

#include "cli/runs/explore.hpp"
#include "datasets/terrain_file.hpp"

namespace tcert::cli {

/// The request with what was given by flag in cells; the terrain's frame takes --cell-size if the
/// file declared none. \throws UsageError for --units metres of a terrain whose
/// cells have no size or are not square, and for places outside of it.
[[nodiscard]] ExploreRequest in_cells(const ExploreRequest& request, TerrainGrid& terrain);

/// The map that ways are written on besides cells: none unless metres were asked for.
[[nodiscard]] std::optional<MapFrame> map_of(const ExploreRequest& request,
                                             const TerrainGrid& terrain);

}  // namespace tcert::cli
