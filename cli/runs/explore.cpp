#include "cli/runs/explore.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
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
  const bool certifies =
      setup.rules.kind == terrain::RuleSet::certified || setup.rules.kind == terrain::RuleSet::band;
  const auto is_known = [&](terrain::Cell c) {
    return certifies &&
           std::any_of(setup.known.begin(), setup.known.end(), [&](const terrain::Measurement& m) {
             return m.at == terrain::position(c);
           });
  };
  for (const terrain::Cell c : setup.first_cells) {
    if (is_known(c)) {
      continue;  // It was not measured again.
    }
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

/// A request with what it is about.
struct Task {
  const ExploreRequest& request;  ///< As it was given, for the manifest.
  ExploreRequest options;         ///< In cells.
  TerrainGrid file;
  Terrain ground;
  Places places;
  terrain::CellSet blocked;
  std::optional<SyntheticLabel> label;
  std::vector<ManifestFile> inputs;

  [[nodiscard]] std::string heading() const { return label ? to_string(*label) + "\n" : ""; }
};

/// None without an output.
[[nodiscard]] std::optional<ResultFolder> folder_of(const Task& task) {
  if (task.options.output.path.empty()) {
    return std::nullopt;
  }
  require_apart(task.options.terrain, task.options.output.path);
  return std::optional<ResultFolder>(std::in_place, task.options.output.path, "explore");
}

void commit(ResultFolder& folder, Task& task) {
  Manifest manifest;
  manifest.command = "explore";
  record(written(task.request), manifest);
  manifest.seed = static_cast<std::uint64_t>(task.request.seed);
  manifest.synthetic = task.label;
  manifest.inputs = std::move(task.inputs);
  folder.commit(std::move(manifest));
}

ExitCode walk_baseline(Task& task, Progress& progress) {
  const ExploreSetup setup = places_setup(task.options, task.places, std::move(task.blocked));
  std::optional<ResultFolder> folder = folder_of(task);
  const terrain::BaselineResult result = baseline_walk(task.options, task.ground, setup);
  progress.show(task.heading() + baseline_summary(task.options.baseline, result));
  if (folder) {
    folder->write("path.csv",
                  render(path_table(result.path, task.label, map_of(task.options, task.file)),
                         TableFormat::csv));
    ExploreFrame frame;
    frame.safe = frame.expanders = terrain::CellSet(task.ground.grid.size(), 0);
    frame.robot = result.path.back();
    frame.path_points = result.path.size();
    folder->write(
        "frames/frame_001.svg",
        explore_picture(
            task.ground, task.options.threshold, frame, result.path, setup.goal, task.label));
    if (raster_formats_of(task.options.rasters).png) {
      write_terrain_picture(*folder, task.file, setup);
    }
    commit(*folder, task);
  }
  return result.reached ? exit_done : exit_step_limit;
}

void write_frames(const ResultFolder& folder,
                  const Task& task,
                  const ExploreSetup& setup,
                  const ExploreResult& result,
                  const FrameKeeper& frames) {
  int number = 0;
  std::vector<ExploreFrame> chosen = frames.evenly(static_cast<std::size_t>(task.options.frames));
  if (!chosen.empty()) {
    chosen.back().robot = result.path.back();
    chosen.back().path_points = result.path.size();
  }
  for (const ExploreFrame& frame : chosen) {
    folder.write(fmt::format("frames/frame_{:03}.svg", ++number),
                 explore_picture(task.ground,
                                 setup.rules.threshold,
                                 frame,
                                 result.path,
                                 setup.goal ? std::optional(result.goal) : std::nullopt,
                                 task.label));
  }
}

ExitCode run_exploration(Task& task, Progress& progress) {
  const ExploreRequest& options = task.options;
  const RasterFormats rasters = raster_formats_of(options.rasters);
  ExploreSetup setup = explore_setup(options, progress, task.ground, std::move(task.blocked));
  setup.wants_layers = rasters.any();
  std::optional<ResultFolder> folder = folder_of(task);
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
  const ExploreResult result = explored(task.ground, setup, keep);
  const double cell_m = options.units == "metres" ? task.file.frame.x_step : 0.0;
  progress.show(task.heading() + explore_summary(result, setup, cell_m));
  if (folder) {
    folder->write("series.csv", render(explore_table(result, task.label), TableFormat::csv));
    folder->write(
        "path.csv",
        render(path_table(result.path, task.label, map_of(options, task.file)), TableFormat::csv));
    folder->write("measurements.csv",
                  render(measurement_table(taken_by(task.ground, setup, result), task.label),
                         TableFormat::csv));
    write_frames(*folder, task, setup, result, frames);
    if (result.layers) {
      write_rasters(*folder, rasters, task.file, *result.layers);
    }
    if (rasters.png) {
      write_terrain_picture(*folder, task.file, setup);
    }
    commit(*folder, task);
  }
  return exit_code_of(result.end);
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
  options = in_cells(options, file);
  say_of_threshold(options.terrain, file, options.threshold, progress);
  check_limits(options);
  require_writable(raster_formats_of(options.rasters), file);
  const terrain::Grid grid{file.rows, file.columns};
  const Places places = places_of(options, grid);
  terrain::CellSet blocked = blocked_cells(file, options.obstacles, reading, progress);
  require_free(grid, file, blocked, places.start, places.goals);
  Terrain ground{grid, file.values};
  const std::optional<SyntheticLabel> label = label_of(file);
  Task task{request,
            std::move(options),
            std::move(file),
            std::move(ground),
            places,
            std::move(blocked),
            label,
            std::move(inputs)};
  return task.options.baseline.empty() ? run_exploration(task, progress)
                                       : walk_baseline(task, progress);
}

}  // namespace tcert::cli
