#include "cli/runs/simulate_terrain.hpp"

#include "cli/runs/result_folder.hpp"
#include "cli/runs/written_options.hpp"

namespace tcert::cli {
namespace {

[[nodiscard]] TerrainGrid field_of(const SimulateTerrainRequest& request) {
  TerrainFieldOptions field;
  field.kind = request.kind == "matern52"   ? FieldKind::matern52
               : request.kind == "matern32" ? FieldKind::matern32
                                            : FieldKind::gaussian;
  field.rows = static_cast<int>(request.rows);
  field.columns = static_cast<int>(request.columns);
  field.mean = request.mean;
  field.length_scale = request.length_scale;
  field.lipschitz = request.lipschitz;
  field.seed = static_cast<std::uint64_t>(request.seed);
  return random_terrain(field);
}

[[nodiscard]] TerrainGrid craters_of(const SimulateTerrainRequest& request) {
  for (const char* const option : {"mean", "length-scale", "lipschitz"}) {
    if (is_given(request.given, option)) {
      throw UsageError("--" + std::string(option) + " has no effect on craters");
    }
  }
  CraterFieldOptions craters;
  craters.rows = static_cast<int>(request.rows);
  craters.columns = static_cast<int>(request.columns);
  craters.seed = static_cast<std::uint64_t>(request.seed);
  if (craters.rows < 3 || craters.columns < 3) {
    throw UsageError("craters need at least 3 --rows and --columns");
  }
  return crater_slopes(craters);
}

}  // namespace

OptionTable options_of(SimulateTerrainRequest& request) {
  OptionTable table(request.given);
  table
      .add("kind",
           request.kind,
           "WORD",
           "covariance: gaussian (smooth), matern52, matern32 (rougher); or craters, 25 less the "
           "slope in degrees of ground full of them, which takes neither mean nor length scale nor "
           "lipschitz")
      .one_of({"gaussian", "matern52", "matern32", "craters"});
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
  const SyntheticLabel label{static_cast<std::uint64_t>(request.seed)};
  TerrainGrid terrain = request.kind == "craters" ? craters_of(request) : field_of(request);
  terrain.header = to_string(label);
  Manifest manifest;
  manifest.command = "simulate";
  record(written(request), manifest);
  manifest.arguments.insert(manifest.arguments.begin(), {"terrain"});
  manifest.seed = label.seed;
  manifest.synthetic = label;
  write_with_manifest(output, terrain_text(terrain), std::move(manifest));
  progress.sum_up(to_string(label) + " " + std::to_string(terrain.rows) + " x " +
                  std::to_string(terrain.columns) + " cells in " + output + ".");
  return exit_done;
}

}  // namespace tcert::cli
