#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "cli/errors.hpp"
#include "cli/explore_options.hpp"
#include "cli/output.hpp"
#include "cli/result_folder.hpp"
#include "datasets/terrain_file.hpp"
#include "reports/terrain/explore_table.hpp"
#include "reports/terrain/picture.hpp"

namespace tcert::cli {
namespace {

using terrain::ExploreResult;
using terrain::ExploreSetup;
using terrain::Terrain;

constexpr std::string_view kSyntheticPrefix = "SYNTHETIC data, seed ";

[[nodiscard]] TerrainGrid read_or_throw(const std::string& path, const std::string& header) {
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) {
    throw NoInput("cannot read the terrain '" + path + "': there is no such file");
  }
  TerrainFileOptions options;
  options.header = header == "yes"  ? TerrainHeader::yes
                   : header == "no" ? TerrainHeader::no
                                    : TerrainHeader::detect;
  TerrainFileResult file = read_terrain(path, options);
  if (!file.terrain) {
    say(file.diagnostics);
    throw BadData("'" + path + "' is no terrain");
  }
  return std::move(*file.terrain);
}

/// The label that `simulate terrain` writes as the first line.
[[nodiscard]] std::optional<SyntheticLabel> label_of(const TerrainGrid& grid) {
  if (grid.header.rfind(kSyntheticPrefix, 0) != 0) {
    return std::nullopt;
  }
  return SyntheticLabel{std::strtoull(grid.header.c_str() + kSyntheticPrefix.size(), nullptr, 10)};
}

[[nodiscard]] terrain::CellSet blocked_cells(const ExploreOptions& o, const terrain::Grid& grid) {
  if (o.obstacles.empty()) {
    return {};
  }
  const TerrainGrid layer = read_or_throw(o.obstacles, "detect");
  if (layer.rows != grid.rows || layer.columns != grid.columns) {
    throw BadData(fmt::format("'{}': found {} x {} cells, expected the terrain's {} x {}",
                              o.obstacles,
                              layer.rows,
                              layer.columns,
                              grid.rows,
                              grid.columns));
  }
  terrain::CellSet blocked(grid.size());
  for (std::size_t i = 0; i < blocked.size(); ++i) {
    blocked[i] = layer.values[i] != 0.0 ? 1 : 0;
  }
  return blocked;
}

[[nodiscard]] std::string summary(const ExploreResult& result, const ExploreSetup& setup) {
  const terrain::ExploreStep& last = result.last();
  std::string text = fmt::format("end: {}\n", terrain::to_string(result.end));
  if (result.end == terrain::End::not_reachable && setup.goal) {
    text += fmt::format(
        "the goal ({}, {}) is not reachable at this threshold: {} cells are certified, and the "
        "frontier stands at ({}, {}), {:.1f} cells from the goal\n",
        setup.goal->x,
        setup.goal->y,
        last.safe,
        result.frontier.x(),
        result.frontier.y(),
        (terrain::position(*setup.goal) - result.frontier).norm());
  }
  text += fmt::format(
      "rules: {}\nmeasurements: {} first, {} after\nsafe cells: {}\ntravelled: {:.1f} cells\n",
      terrain::to_string(setup.rules.kind),
      setup.first_cells.size() + 1,
      result.steps.size() - 1,
      last.safe,
      last.travelled);
  if (setup.goal) {
    text += last.certificate && std::isfinite(*last.certificate)
                ? fmt::format("certificate: {:.6g}\n", *last.certificate)
                : "certificate: NA\n";
  }
  text += fmt::format(
      "Lipschitz constant: {:.6g}\nunsafe cells held to be safe, at most: {}\nsteps "
      "onto unsafe cells: {}\n",
      last.lipschitz,
      result.most_unsafe_certified,
      last.unsafe_visits);
  if (setup.motion == terrain::Motion::reactive) {
    text +=
        fmt::format("ways left by the controller to a route: {}\n", result.controller_fallbacks);
  }
  return text;
}

int run(Arguments arguments) {
  ExploreOptions options;
  CommonOptions common;
  if (!parse(explore_command_line(options), common, arguments)) {
    return exit_done;
  }
  apply_config(options, common);
  check(options);
  TerrainGrid file = read_or_throw(options.terrain, options.header);
  const std::optional<SyntheticLabel> label = label_of(file);
  const Terrain ground{{file.rows, file.columns}, std::move(file.values)};
  ExploreSetup setup = explore_setup(options, common, ground);
  setup.blocked = blocked_cells(options, ground.grid);
  if (!setup.blocked.empty() && setup.blocked[ground.grid.index(setup.start)] != 0) {
    throw BadData("the start lies in a physical obstacle");
  }
  std::optional<ResultFolder> folder;
  if (!common.output.empty()) {
    require_apart(options.terrain, common.output);
    folder.emplace(common.output, "explore");
  }
  FrameKeeper frames;
  const auto keep = [&](const terrain::Planner& planner,
                        const terrain::ExploreStep& step,
                        const ExploreResult& so_far) {
    if (folder && options.frames > 0) {
      frames.add({step.step,
                  planner.safe(),
                  planner.considered(),
                  so_far.path.back(),
                  so_far.free_space,
                  step.next,
                  so_far.path.size()});
    }
  };
  const ExploreResult result = explore(ground, setup, keep);
  std::string text = label ? to_string(*label) + "\n" : "";
  text += summary(result, setup);
  print(text);
  if (folder) {
    folder->write("series.csv", render(explore_table(result, label), TableFormat::csv));
    folder->write("path.csv", render(path_table(result, label), TableFormat::csv));
    int number = 0;
    std::vector<ExploreFrame> chosen = frames.evenly(static_cast<std::size_t>(options.frames));
    if (!chosen.empty()) {
      chosen.back().robot = result.path.back();
      chosen.back().path_points = result.path.size();
    }
    for (const ExploreFrame& frame : chosen) {
      folder->write(
          fmt::format("frame_{}.svg", ++number),
          explore_picture(ground, setup.rules.threshold, frame, result.path, setup.goal, label));
    }
    Manifest manifest;
    manifest.command = "explore";
    manifest.options = common.effective;
    manifest.seed = static_cast<std::uint64_t>(common.seed);
    manifest.synthetic = label;
    manifest.inputs = {{name_of(options.terrain), digest_file(options.terrain)}};
    for (const std::string& more : {options.config, options.obstacles}) {
      if (!more.empty()) {
        manifest.inputs.push_back({name_of(more), digest_file(more)});
      }
    }
    folder->commit(std::move(manifest));
  }
  return exit_done;
}

}  // namespace

const Command kExplore = {"explore", "explore a terrain that is felt one cell at a time", run};

}  // namespace tcert::cli
