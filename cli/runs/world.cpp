#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <table/path_name.hpp>

#include "analysis/study/truth/truth.hpp"
#include "cli/command.hpp"
#include "cli/data_file.hpp"
#include "cli/errors.hpp"
#include "cli/options.hpp"
#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/result_folder.hpp"
#include "datasets/worlds/world_files.hpp"
#include "reports/world_picture.hpp"
#include "reports/world_table.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kText =
    R"(The truth of known worlds: the best margin that any path from S to G has.

T is the largest value, over all paths, of min(clearance slack, turn radius - least turn radius).
Printed as an interval: at least what a path that was found and measured is worth, at most what the
clearance alone allows, which is exact for fields of discs and within a stated error for others.

Files: .json or .jsonl (the worlds of a bundle; one, an array, one a line), .csv of discs
(world,x_m,y_m,radius_m), .map of MovingAI, .yaml of ROS map_server with its PGM image (unknown is
occupied); also .gz and .zst. A world that cannot be used is named, the others go on (exit code 3).
Everything outside of a world's bounds is occupied; a CSV's bounds hold its discs, S and G.

Usage: tcert world FILE... [options]

Example:
  tcert world corpus/worlds/*.json --format csv --output truth.csv
  tcert world cylinders.csv --start=-2.25,3,0.25 --goal=-2.25,13,1 --body-width 0.43 --picture svg
  tcert world maze.map --start 1.5,510.5,0.4 --goal 509.5,1.5,0.4 --step 0.25 --no-curvature

Cost: about a millisecond a world of 300 discs without curvature, some 0.2 s with; a second for a
million cells of a grid.
)";

struct WorldOptions {
  std::string first;
  std::vector<std::string> rest;
  std::string clearance = "width";
  double body_width_m = 0.45;
  double min_turn_radius_m = 0.35;
  double step_m = 0.02;
  double cell_m = 1.0;
  bool no_curvature = false;
  std::string start;
  std::string goal;
  std::string bounds;
  std::string picture;
};

CommandLine command_line(WorldOptions& o) {
  CommandLine line{"world",
                   kText,
                   uses_output | uses_format | uses_threads | uses_config,
                   po::options_description("Options"),
                   {{"FILE", &o.first, true, OptionRole::input}},
                   &o.rest};
  line.own.add_options()("clearance",
                         po::value(&o.clearance)->value_name("WORD")->default_value(o.clearance),
                         "width: 2 clearance - body width; radial: half of that; as the "
                         "certificate it is held against")(
      "body-width",
      po::value(&o.body_width_m)->value_name("M")->default_value(o.body_width_m, "0.45"),
      "of the robot")(
      "min-turn-radius",
      po::value(&o.min_turn_radius_m)->value_name("M")->default_value(o.min_turn_radius_m, "0.35"),
      "of the robot")("no-curvature",
                      po::bool_switch(&o.no_curvature),
                      "leave the turn radius out: quick, and no path is drawn for it")(
      "step",
      po::value(&o.step_m)->value_name("M")->default_value(o.step_m, "0.02"),
      "of the grid for worlds that are not of discs; the error is 1.42 steps")(
      "cell-size",
      po::value(&o.cell_m)->value_name("M")->default_value(o.cell_m, "1"),
      "of a cell of a MovingAI map")(
      "start",
      po::value(&o.start)->value_name("X,Y,R"),
      "S, a disc, for files that have none; write --start=-1,2,0.3 if X is negative")(
      "goal", po::value(&o.goal)->value_name("X,Y,R"), "G likewise")(
      "bounds", po::value(&o.bounds)->value_name("X,Y,X,Y"), "low and high corner, for a CSV")(
      "picture",
      output(o.picture, "DIR"),
      "also draw each world, its widest path and its bottleneck: DIR/<world>.svg");
  return line;
}

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

WorldFrame frame_of(const WorldOptions& options) {
  WorldFrame frame;
  frame.start = region_of("start", options.start);
  frame.goal = region_of("goal", options.goal);
  frame.cell_m = options.cell_m;
  if (!options.bounds.empty()) {
    const std::vector<double> v = numbers_of("bounds", options.bounds);
    if (v.size() != 4 || !(v[0] < v[2] && v[1] < v[3])) {
      throw UsageError("--bounds: found '" + options.bounds + "', expected low x,y and high x,y");
    }
    frame.bounds = Bounds{{v[0], v[1]}, {v[2], v[3]}};
  }
  return frame;
}

study::TruthOptions truth_options(const WorldOptions& options) {
  require_range("body-width", options.body_width_m, 1e-3, 1e3);
  require_range("min-turn-radius", options.min_turn_radius_m, 0.0, 1e3);
  require_range("step", options.step_m, 1e-6, 1e3);
  require_range("cell-size", options.cell_m, 1e-6, 1e6);
  study::TruthOptions truth;
  if (options.clearance == "radial") {
    truth.convention = study::SlackConvention::radial;
  } else if (options.clearance != "width") {
    throw UsageError("--clearance: found '" + options.clearance + "', expected width or radial" +
                     did_you_mean(options.clearance, {"width", "radial"}));
  }
  truth.step_m = options.step_m;
  truth.curvature = !options.no_curvature;
  return truth;
}

struct Answer {
  study::Truth truth;
  std::string picture;
  std::string problem;
};

Answer answer(const World& world,
              const Robot& robot,
              const study::TruthOptions& options,
              bool picture) {
  Answer result;
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

int run(Arguments arguments) {
  WorldOptions options;
  CommonOptions common;
  if (!parse(command_line(options), common, arguments)) {
    return exit_done;
  }
  require_own_file(common.output);
  const study::TruthOptions truth = truth_options(options);
  const WorldFrame frame = frame_of(options);
  Robot robot;
  robot.body_width_m = options.body_width_m;
  robot.min_turn_radius_m = options.min_turn_radius_m;

  std::vector<std::string> files{options.first};
  files.insert(files.end(), options.rest.begin(), options.rest.end());
  std::vector<World> worlds;
  Manifest manifest;
  bool rejected = false;
  for (const std::string& file : files) {
    if (!std::filesystem::exists(file)) {
      throw NoInput("no world at '" + file + "'");
    }
    for (const std::string& output : {common.output, options.picture}) {
      if (!output.empty()) {
        require_apart(file, output);
      }
    }
    WorldsResult read = read_worlds(file, frame);
    say(read.diagnostics);
    rejected = rejected || table::has_error(read.diagnostics);
    std::move(read.worlds.begin(), read.worlds.end(), std::back_inserter(worlds));
    if (std::filesystem::is_regular_file(file)) {
      manifest.inputs.push_back({name_of(file), digest_file(file)});
    }
  }
  if (worlds.empty()) {
    throw BadData("there is no world that can be used");
  }

  std::optional<ResultFolder> pictures;
  if (!options.picture.empty()) {
    pictures.emplace(options.picture, "world");
  }
  const ThreadLimit threads(common.threads);
  std::vector<Answer> answers(worlds.size());
  Progress progress("worlds", worlds.size(), common.quiet);
  std::mutex counting;
  tbb::parallel_for(std::size_t{0}, worlds.size(), [&](std::size_t i) {
    answers[i] = answer(worlds[i], robot, truth, !options.picture.empty());
    const std::lock_guard lock(counting);
    progress.advance();
  });

  Table table = world_table(robot, truth);
  for (std::size_t i = 0; i < worlds.size(); ++i) {
    if (!answers[i].problem.empty()) {
      say(answers[i].problem);
      rejected = true;
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
  manifest.command = "world";
  record(common, manifest);
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
  const std::string text = render(table, common.table_format());
  if (common.output.empty()) {
    print(text);
  } else {
    write_with_manifest(common.output, text, std::move(manifest));
  }
  return rejected ? exit_rejected : exit_done;
}

}  // namespace

const Command kWorld = {"world", "the truth of known worlds: the best margin a path has", run};

}  // namespace tcert::cli
