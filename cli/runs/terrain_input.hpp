#pragma once
/// \file
/// Terrain files as a command is given them.

#include <string>
#include <terrain/explore.hpp>

#include "cli/runs/progress.hpp"
#include "datasets/terrain_file.hpp"
#include "reports/table.hpp"

namespace tcert::cli {

/// "auto", "yes" or "no"; "auto", "grid", "xyz" or "esri"; "auto", "none" or a number.
/// \throws UsageError naming --header, --terrain-format or --nodata.
[[nodiscard]] TerrainFileOptions terrain_file_options(const std::string& header,
                                                      const std::string& format,
                                                      const std::string& nodata);

/// Reads a terrain, or a layer of one, and says how it was understood.
/// \throws NoInput, BadData.
[[nodiscard]] TerrainGrid read_terrain_or_throw(const std::string& path,
                                                const TerrainFileOptions& options,
                                                Progress& progress);

/// Says if no cell is safe at the threshold, or every one: units that do not fit.
void say_of_threshold(const std::string& path,
                      const TerrainGrid& terrain,
                      double threshold,
                      Progress& progress);

/// The label that `simulate terrain` writes as the first line.
[[nodiscard]] std::optional<SyntheticLabel> label_of(const TerrainGrid& grid);

/// Cells that are not to be measured or entered: gaps of the terrain and, of the file `obstacles`
/// if it is not empty, a layer of the same size, all that are not 0. Empty if there are none.
/// \throws NoInput, BadData.
[[nodiscard]] terrain::CellSet blocked_cells(const TerrainGrid& terrain,
                                             const std::string& obstacles,
                                             const TerrainFileOptions& options,
                                             Progress& progress);

/// \throws BadData if start or goals are blocked, or apart for what is blocked, whatever the
/// ground.
void require_free(const terrain::Grid& grid,
                  const TerrainGrid& terrain,
                  const terrain::CellSet& blocked,
                  terrain::Cell start,
                  const std::vector<terrain::Cell>& goals);

}  // namespace tcert::cli
