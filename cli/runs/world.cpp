#include "cli/runs/world.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <table/path_name.hpp>

#include "analysis/study/truth/truth.hpp"
#include "cli/runs/data_file.hpp"
#include "cli/runs/result_folder.hpp"
#include "cli/runs/thread_limit.hpp"
#include "cli/runs/written_options.hpp"
#include "datasets/worlds/world_files.hpp"
#include "reports/world_picture.hpp"
#include "reports/world_table.hpp"

namespace tcert::cli {
namespace {

std::optional<Region> region_of(const std::string& option, const std::string& list) {
  if (list.empty()) {
    return std::nullopt;
  }
  const std::vector<double> v = numbers_of(option, list);
  if (v.size() != 3 || !(v[2] > 0.0)) {
    throw UsageError("--" + option + ": found '" + list + "', expected x,y,radius");
  }
  return Disc{{v[0], v[1]}, v[2]};
}

WorldFrame frame_of(const WorldRequest& request) {
  WorldFrame frame;
  frame.start = region_of("start", request.start);
  frame.goal = region_of("goal", request.goal);
  frame.cell_m = request.cell_m;
  if (!request.bounds.empty()) {
    const std::vector<double> v = numbers_of("bounds", request.bounds);
    if (v.size() != 4 || !(v[0] < v[2] && v[1] < v[3])) {
      throw UsageError("--bounds: found '" + request.bounds + "', expected low x,y and high x,y");
    }
    frame.bounds = Bounds{{v[0], v[1]}, {v[2], v[3]}};
  }
  return frame;
}

study::TruthOptions truth_options(const WorldRequest& request) {
  study::TruthOptions truth;
  if (request.clearance == "radial") {
    truth.convention = study::SlackConvention::radial;
  } else if (request.clearance != "width") {
    throw UsageError("--clearance: found '" + request.clearance + "', expected width or radial" +
                     did_you_mean(request.clearance, {"width", "radial"}));
  }
  truth.step_m = request.step_m;
  truth.curvature = !request.no_curvature;
  truth.path_cell_m = request.path_cell_m;
  truth.turn_cell_m = request.turn_cell_m;
  if (request.no_curvature && request.turn_cell_m > 0.0) {
    throw UsageError("--turn-cell does nothing to --no-curvature");
  }
  return truth;
}

struct WorldAnswer {
  study::Truth truth;
  std::string picture;
  std::string problem;
};

WorldAnswer answer(const World& world,
                   const Robot& robot,
                   const study::TruthOptions& options,
                   bool picture) {
  WorldAnswer result;
  try {
    result.truth = study::truth_of(world, robot, options);
    if (picture) {
      result.picture =
          world_picture(world, result.truth, study::grid_clearance(world, options.step_m).path);
    }
  } catch (const std::invalid_argument& error) {
    result.problem = error.what();
  }
  return result;
}

/// Names of pictures: each world's own, as far as it can be that of a file; of several that would
/// be the same all but the first are numbered.
class PictureNames {
 public:
  std::string of(const World& world) {
    const std::string name = table::as_file_name(world.name);
    std::string free = name;
    for (int number = 2; !taken_.insert(free).second; ++number) {
      free = name + "_" + std::to_string(number);
    }
    return free + ".svg";
  }

 private:
  std::set<std::string> taken_;
};

/// The worlds of the files, in their order.
struct ReadWorlds {
  std::vector<World> worlds;
  std::vector<ManifestFile> inputs;
  bool rejected = false;
};

ReadWorlds worlds_of(const WorldRequest& request, Progress& progress) {
  const WorldFrame frame = frame_of(request);
  std::vector<std::string> files{request.first};
  files.insert(files.end(), request.rest.begin(), request.rest.end());
  ReadWorlds all;
  for (const std::string& file : files) {
    if (!std::filesystem::exists(file)) {
      throw NoInput("no world at '" + file + "'");
    }
    for (const std::string& output : {request.output.path, request.picture}) {
      if (!output.empty()) {
        require_apart(file, output);
      }
    }
    WorldsResult read = read_worlds(file, frame);
    progress.say(read.diagnostics);
    all.rejected = all.rejected || table::has_error(read.diagnostics);
    std::move(read.worlds.begin(), read.worlds.end(), std::back_inserter(all.worlds));
    if (std::filesystem::is_regular_file(file)) {
      all.inputs.push_back({name_of(file), digest_file(file)});
    }
  }
  if (all.worlds.empty()) {
    throw BadData("there is no world that can be used");
  }
  return all;
}

}  // namespace

OptionTable options_of(WorldRequest& request) {
  OptionTable table(request.given);
  table.argument({"FILE", &request.first, true, OptionRole::input});
  table.rest(request.rest);
  table.add("clearance",
            request.clearance,
            "WORD",
            "width: 2 clearance - body width; radial: half of that; as the certificate it is held "
            "against");
  table.add("body-width", request.body_width_m, "M", "of the robot").within(1e-3, 1e3);
  table.add("min-turn-radius", request.min_turn_radius_m, "M", "of the robot").within(0.0, 1e3);
  table.add("no-curvature",
            request.no_curvature,
            "leave the turn radius out: quick, and no path is drawn for it");
  table
      .add("step",
           request.step_m,
           "M",
           "of the grid for worlds that are not of discs; the error is 1.42 steps")
      .within(1e-6, 1e3);
  table
      .add(
          "path-cell",
          request.path_cell_m,
          "M",
          "of the cells in which the path of 'T at least' is stretched; smaller may be tighter and "
          "costs more; 0 leaves that out")
      .within(0.0, 1e3);
  table
      .add("turn-cell",
           request.turn_cell_m,
           "M",
           "let 'T at most' know the turning limit, in cells of this size: 0.01 takes up to some "
           "seconds a world, half of it eight times that and is tighter; 0 leaves it that of "
           "clearance alone")
      .within(0.0, 1e3);
  table.add("cell-size", request.cell_m, "M", "of a cell of a MovingAI map").within(1e-6, 1e6);
  table.add("start",
            request.start,
            "X,Y,R",
            "S, a disc, for files that have none; write --start=-1,2,0.3 if X is negative");
  table.add("goal", request.goal, "X,Y,R", "G likewise");
  table.add("bounds", request.bounds, "X,Y,X,Y", "low and high corner, for a CSV");
  table.add_output("picture",
                   request.picture,
                   "DIR",
                   "also draw each world, its widest path and its bottleneck: DIR/<world>.svg");
  add_common(table, request);
  table.config_file();
  return table;
}

ExitCode world(const WorldRequest& request, Progress& progress) {
  const std::string& output = request.output.path;
  require_own_file(output);
  const study::TruthOptions truth = truth_options(request);
  Robot robot;
  robot.body_width_m = request.body_width_m;
  robot.min_turn_radius_m = request.min_turn_radius_m;
  ReadWorlds read = worlds_of(request, progress);
  const std::vector<World>& worlds = read.worlds;

  std::optional<ResultFolder> pictures;
  if (!request.picture.empty()) {
    pictures.emplace(request.picture, "world");
  }
  const ThreadLimit limit(request.threads);
  std::vector<WorldAnswer> answers(worlds.size());
  Stage stage(progress, "worlds", worlds.size());
  std::mutex counting;
  tbb::parallel_for(std::size_t{0}, worlds.size(), [&](std::size_t i) {
    answers[i] = answer(worlds[i], robot, truth, !request.picture.empty());
    const std::lock_guard lock(counting);
    stage.advance();
  });

  Table table = world_table(robot, truth);
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    if (!answers[i].problem.empty()) {
      progress.say(answers[i].problem);
      read.rejected = true;
      continue;
    }
    if (worlds[i].synthetic && !table.synthetic) {
      table.synthetic = SyntheticLabel{worlds[i].seed};
    }
    table.add_row(world_row(worlds[i], answers[i].truth));
  }
  if (table.rows.empty()) {
    throw BadData("there is no world that can be used");
  }
  Manifest manifest;
  manifest.command = "world";
  record(written(request), manifest);
  manifest.inputs = std::move(read.inputs);
  manifest.synthetic = table.synthetic;
  if (pictures) {
    PictureNames names;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
      if (answers[i].problem.empty()) {
        pictures->write(names.of(worlds[i]), answers[i].picture);
      }
    }
    pictures->commit(manifest);
  }
  if (output.empty()) {
    progress.show(shown(table, request.output, progress));
  } else {
    write_with_manifest(output, render(table, request.output.table_format()), std::move(manifest));
  }
  return read.rejected ? exit_rejected : exit_done;
}

}  // namespace tcert::cli
