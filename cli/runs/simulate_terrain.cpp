#include "cli/runs/simulate_terrain.hpp"

#include "cli/runs/result_folder.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {

OptionTable options_of(SimulateTerrainRequest& request) {
  OptionTable table(request.given);
  table.add("rows", request.rows, "N", "lines of the file").within(2, 8192);
  table.add("columns", request.columns, "N", "cells of a line").within(2, 8192);
  table.add("mean", request.mean, "V", "of the values").within(-1e12, 1e12);
  table.add("length-scale", request.length_scale, "CELLS", "of the covariance").within(0.1, 1e6);
  table.add("lipschitz", request.lipschitz, "L", "steepest slope, per cell").within(1e-12, 1e12);
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode simulate_terrain(const SimulateTerrainRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  if (output.empty()) {
    throw UsageError("needs --output FILE");
  }
  require_own_file(output);
  TerrainFieldOptions field;
  field.rows = static_cast<int>(request.rows);
  field.columns = static_cast<int>(request.columns);
  field.mean = request.mean;
  field.length_scale = request.length_scale;
  field.lipschitz = request.lipschitz;
  field.seed = static_cast<std::uint64_t>(request.seed);
  const SyntheticLabel label{field.seed};
  TerrainGrid terrain = random_terrain(field);
  terrain.header = to_string(label);
  Manifest manifest;
  manifest.command = "simulate";
  record(written(request), manifest);
  manifest.arguments.insert(manifest.arguments.begin(), {"terrain"});
  manifest.seed = field.seed;
  manifest.synthetic = label;
  write_with_manifest(output, terrain_text(terrain), std::move(manifest));
  progress.sum_up(to_string(label) + " " + std::to_string(field.rows) + " x " +
                  std::to_string(field.columns) + " cells in " + output + ".");
  return exit_done;
}

}  // namespace tcert::cli
