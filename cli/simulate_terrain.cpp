#include "cli/simulate_terrain.hpp"

#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "datasets/terrain_field/terrain_field.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(Make a random terrain whose Lipschitz constant is stated: no two cells differ by more than it times
their distance. 256 random waves with the covariance of a Gaussian process, scaled.

Usage: tcert simulate terrain --output FILE [options]

Example:
  tcert simulate terrain --output terrain.csv
  tcert simulate terrain --output small.csv --rows 80 --columns 60 --length-scale 10 --lipschitz 40

Cost: 0.2 s at 600 x 400 cells.
)";

}  // namespace

int simulate_terrain(Arguments arguments) {
  TerrainFieldOptions field;
  CommonOptions common;
  std::int64_t rows = field.rows;
  std::int64_t columns = field.columns;
  CommandLine line{"simulate terrain",
                   kText,
                   uses_output | uses_seed | uses_config,
                   po::options_description("Options"),
                   {}};
  line.own.add_options()(
      "rows", po::value(&rows)->value_name("N")->default_value(rows), "lines of the file")(
      "columns", po::value(&columns)->value_name("N")->default_value(columns), "cells of a line")(
      "mean", po::value(&field.mean)->value_name("V")->default_value(field.mean), "of the values")(
      "length-scale",
      po::value(&field.length_scale)->value_name("CELLS")->default_value(field.length_scale),
      "of the covariance")(
      "lipschitz",
      po::value(&field.lipschitz)->value_name("L")->default_value(field.lipschitz),
      "steepest slope, per cell");
  if (!parse(line, common, arguments)) {
    return exit_done;
  }
  require_range("rows", static_cast<double>(rows), 2, 8192);
  require_range("columns", static_cast<double>(columns), 2, 8192);
  require_range("mean", field.mean, -1e12, 1e12);
  require_range("length-scale", field.length_scale, 0.1, 1e6);
  require_range("lipschitz", field.lipschitz, 1e-12, 1e12);
  if (common.output.empty()) {
    throw UsageError("needs --output FILE");
  }
  require_own_file(common.output);
  field.rows = static_cast<int>(rows);
  field.columns = static_cast<int>(columns);
  field.seed = static_cast<std::uint64_t>(common.seed);
  const SyntheticLabel label{field.seed};
  TerrainGrid terrain = random_terrain(field);
  terrain.header = to_string(label);
  Manifest manifest;
  manifest.command = "simulate";
  record(common, manifest);
  manifest.arguments.insert(manifest.arguments.begin(), {"terrain"});
  manifest.seed = field.seed;
  manifest.synthetic = label;
  write_with_manifest(common.output, terrain_text(terrain), std::move(manifest));
  if (!common.quiet) {
    say(to_string(label) + " " + std::to_string(rows) + " x " + std::to_string(columns) +
        " cells in " + common.output + ".");
  }
  return exit_done;
}

}  // namespace tcert::cli
