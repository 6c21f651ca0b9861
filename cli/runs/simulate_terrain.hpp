#pragma once
/// \file
/// `simulate terrain`: random fields with a stated Lipschitz constant.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"
#include "datasets/terrain_field/crater_field.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::cli {

struct SimulateTerrainRequest {
  std::string kind = "gaussian";
  std::int64_t rows = TerrainFieldOptions().rows;
  std::int64_t columns = TerrainFieldOptions().columns;
  double mean = TerrainFieldOptions().mean;
  double length_scale = TerrainFieldOptions().length_scale;
  double lipschitz = TerrainFieldOptions().lipschitz;
  OutputPath output;
  std::int64_t seed = 1;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(SimulateTerrainRequest& request);

/// \throws UsageError, WriteError.
[[nodiscard]] ExitCode simulate_terrain(const SimulateTerrainRequest& request, Progress& progress);

}  // namespace tcert::cli
