#include "cli/runs/explore.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/runs/explore_baseline.hpp"
#include "cli/runs/explore_config.hpp"
#include "cli/runs/explore_flags.hpp"
#include "cli/runs/explore_rasters.hpp"
#include "cli/runs/explore_setup.hpp"
#include "cli/runs/explore_summary.hpp"
#include "cli/runs/explore_units.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/terrain_input.hpp"
#include "cli/runs/written_options.hpp"
#include "reports/terrain/explore_table.hpp"
#include "reports/terrain/picture.hpp"

namespace tcert::cli {
namespace {

using terrain::ExploreResult;
using terrain::ExploreSetup;
using terrain::Terrain;

/// \throws BadData for a setup that the exploration refuses.
[[nodiscard]] ExploreResult explored(const Terrain& ground,
                                     const ExploreSetup& setup,
                                     const terrain::Observer& keep) {
  try {
    return terrain::explore(ground, setup, keep);
  } catch (const std::invalid_argument& error) {
    throw BadData(error.what());
  } catch (const std::domain_error& error) {
    throw BadData(error.what());
  }
}

/// Known, measured first, and then where the robot planned.
[[nodiscard]] std::vector<TakenMeasurement> taken_by(const Terrain& ground,
                                                     const ExploreSetup& setup,
                                                     const ExploreResult& result) {
  std::vector<TakenMeasurement> taken;
  for (const terrain::Measurement& m : setup.known) {
    taken.push_back({m, false});
  }
  for (const terrain::Cell c : setup.first_cells) {
    taken.push_back({{terrain::position(c), ground.at(c)}, false});
  }
  for (const terrain::ExploreStep& step : result.steps) {
    taken.push_back({{step.at, step.value}, true});
  }
  return taken;
}

/// For the manifest; none if there will be no manifest. \throws NoInput.
std::vector<ManifestFile> inputs_of(const ExploreRequest& options) {
  std::vector<ManifestFile> inputs;
  for (const std::string& path :
       {options.terrain, options.config, options.obstacles, options.known}) {
    if (options.output.path.empty() || path.empty()) {
      continue;
    }
    if (!std::filesystem::exists(path)) {
      throw NoInput("cannot read '" + path + "': there is no such file");
    }
    inputs.push_back({name_of(path), digest_file(path)});
  }
  return inputs;
}

}  // namespace

ExitCode explore(const ExploreRequest& request, Progress& progress) {
  ExploreRequest options = request;
  apply_config(options, progress);
  settle_beta(options, progress);
  check(options, progress);
  const TerrainFileOptions reading =
      terrain_file_options(options.header, options.format, options.nodata);
  // Before they are read, not after hours of exploring, in which they may be edited.
  std::vector<ManifestFile> inputs = inputs_of(options);
  TerrainGrid file = read_terrain_or_throw(options.terrain, reading, progress);
  const std::optional<SyntheticLabel> label = label_of(file);
  options = in_cells(options, file);
  const terrain::Grid grid{file.rows, file.columns};
  const Places places = places_of(options, grid);
  terrain::CellSet blocked = blocked_cells(file, options.obstacles, reading, progress);
  require_free(grid, file, blocked, places.start, places.goals);
  const RasterFormats rasters = raster_formats_of(options.rasters);
  const Terrain ground{grid, file.values};
  std::optional<ResultFolder> folder;
  const auto open_folder = [&] {
    if (!options.output.path.empty()) {
      require_apart(options.terrain, options.output.path);
      folder.emplace(options.output.path, "explore");
    }
  };
  const auto commit = [&] {
    Manifest manifest;
    manifest.command = "explore";
    record(written(request), manifest);
    manifest.seed = static_cast<std::uint64_t>(request.seed);
    manifest.synthetic = label;
    manifest.inputs = std::move(inputs);
    folder->commit(std::move(manifest));
  };
  const std::string heading = label ? to_string(*label) + "\n" : "";
  const double cell_m = options.units == "metres" ? file.frame.x_step : 0.0;

  if (!options.baseline.empty()) {
    const ExploreSetup walked = places_setup(options, places, std::move(blocked));
    const terrain::BaselineResult result = baseline_walk(options, ground, walked);
    open_folder();
    progress.show(heading + baseline_summary(options.baseline, result));
    if (folder) {
      ExploreResult path;
      path.path = result.path;
      folder->write("path.csv", render(path_table(path, label), TableFormat::csv));
      ExploreFrame frame;
      frame.safe = frame.expanders = terrain::CellSet(grid.size(), 0);
      frame.robot = result.path.back();
      frame.path_points = result.path.size();
      folder->write(
          "frames/frame_001.svg",
          explore_picture(ground, options.threshold, frame, result.path, walked.goal, label));
      if (rasters.png) {
        write_terrain_picture(*folder, file, walked);
      }
      commit();
    }
    return result.reached ? exit_done : exit_step_limit;
  }

  ExploreSetup setup = explore_setup(options, progress, ground, std::move(blocked));
  setup.wants_layers = rasters.any();
  open_folder();
  FrameKeeper frames;
  const auto keep = [&](const terrain::Planner& planner,
                        const terrain::ExploreStep& step,
                        const ExploreResult& so_far) {
    if (folder && options.frames > 0) {
      frames.add({step.step,
                  planner.ground(),
                  planner.considered(),
                  so_far.path.back(),
                  so_far.free_space,
                  step.next,
                  so_far.path.size()});
    }
  };
  const ExploreResult result = explored(ground, setup, keep);
  progress.show(heading + explore_summary(result, setup, cell_m));
  if (folder) {
    folder->write("series.csv", render(explore_table(result, label), TableFormat::csv));
    folder->write("path.csv", render(path_table(result, label), TableFormat::csv));
    folder->write(
        "measurements.csv",
        render(measurement_table(taken_by(ground, setup, result), label), TableFormat::csv));
    int number = 0;
    std::vector<ExploreFrame> chosen = frames.evenly(static_cast<std::size_t>(options.frames));
    if (!chosen.empty()) {
      chosen.back().robot = result.path.back();
      chosen.back().path_points = result.path.size();
    }
    for (const ExploreFrame& frame : chosen) {
      folder->write(fmt::format("frames/frame_{:03}.svg", ++number),
                    explore_picture(ground,
                                    setup.rules.threshold,
                                    frame,
                                    result.path,
                                    setup.goal ? std::optional(result.goal) : std::nullopt,
                                    label));
    }
    if (result.layers) {
      write_rasters(*folder, rasters, file, *result.layers);
    }
    if (rasters.png) {
      write_terrain_picture(*folder, file, setup);
    }
    commit();
  }
  return exit_code_of(result.end);
}

}  // namespace tcert::cli
