#include "cli/runs/explore.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/runs/explore_config.hpp"
#include "cli/runs/explore_flags.hpp"
#include "cli/runs/explore_setup.hpp"
#include "cli/runs/explore_summary.hpp"
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
  const terrain::Grid grid{file.rows, file.columns};
  const Places places = places_of(options, grid);
  terrain::CellSet blocked = blocked_cells(file, options.obstacles, reading, progress);
  require_free(grid, file, blocked, places.start, places.goals);
  const Terrain ground{grid, std::move(file.values)};
  const ExploreSetup setup = explore_setup(options, progress, ground, std::move(blocked));
  std::optional<ResultFolder> folder;
  if (!options.output.path.empty()) {
    require_apart(options.terrain, options.output.path);
    folder.emplace(options.output.path, "explore");
  }
  FrameKeeper frames;
  std::vector<terrain::Measurement> measurements;
  const auto keep = [&](const terrain::Planner& planner,
                        const terrain::ExploreStep& step,
                        const ExploreResult& so_far) {
    measurements = planner.measurements();
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
  std::string text = label ? to_string(*label) + "\n" : "";
  text += explore_summary(result, setup);
  progress.show(text);
  if (folder) {
    folder->write("series.csv", render(explore_table(result, label), TableFormat::csv));
    folder->write("path.csv", render(path_table(result, label), TableFormat::csv));
    folder->write("measurements.csv",
                  render(measurement_table(measurements, label), TableFormat::csv));
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
    Manifest manifest;
    manifest.command = "explore";
    record(written(request), manifest);
    manifest.seed = static_cast<std::uint64_t>(request.seed);
    manifest.synthetic = label;
    manifest.inputs = std::move(inputs);
    folder->commit(std::move(manifest));
  }
  return exit_code_of(result.end);
}

}  // namespace tcert::cli
