#include "datasets/worlds/world_files.hpp"

#include <iterator>
#include <set>
#include <table/file_kind.hpp>
#include <utility>

#include "datasets/worlds/world_problems.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;

void reject(WorldsResult& result, const fs::path& path, std::string expectation) {
  result.diagnostics.push_back(
      {table::Severity::error, path.string(), 0, "", "", std::move(expectation), 1});
}

WorldsResult read_ros_map(const table::Bytes& yaml, const fs::path& path, const WorldFrame& frame) {
  WorldsResult result;
  const auto map = read_ros_yaml(yaml, path.string(), result.diagnostics);
  if (!map) {
    return result;
  }
  const fs::path image = path.parent_path() / map->image;
  const table::BytesResult bytes = table::read_file(image);
  if (!bytes.bytes) {
    reject(result, image, "a readable file: " + bytes.problem);
    return result;
  }
  WorldsResult world = world_from_image(*bytes.bytes, image.string(), *map, frame);
  result.worlds = std::move(world.worlds);
  std::move(
      world.diagnostics.begin(), world.diagnostics.end(), std::back_inserter(result.diagnostics));
  return result;
}

WorldsResult read_any(const fs::path& path, const fs::path& name, const WorldFrame& frame) {
  WorldsResult result;
  const table::BytesResult bytes = table::read_file(path);
  if (!bytes.bytes) {
    reject(result, path, "a readable file: " + bytes.problem);
    return result;
  }
  if (const auto binary = table::kind_of_binary(bytes.bytes->view(), path.string())) {
    reject(result, path, table::text_expected(*binary));
    return result;
  }
  const std::string kind = name.extension().string();
  if (kind == ".json" || kind == ".jsonl") {
    result = worlds_from_json(*bytes.bytes, path.string());
    for (World& world : result.worlds) {
      world.start = frame.start ? frame.start : world.start;
      world.goal = frame.goal ? frame.goal : world.goal;
    }
    return result;
  }
  if (kind == ".csv") {
    return worlds_from_disc_csv(*bytes.bytes, path.string(), frame);
  }
  if (kind == ".map") {
    return world_from_moving_ai(*bytes.bytes, path.string(), frame);
  }
  if (kind == ".yaml" || kind == ".yml") {
    return read_ros_map(*bytes.bytes, path, frame);
  }
  reject(result, path, "a name that ends in .json, .jsonl, .csv, .map or .yaml");
  return result;
}

}  // namespace

WorldsResult read_worlds(const fs::path& path, const WorldFrame& frame) {
  fs::path name = path.filename();
  if (name.extension() == ".gz" || name.extension() == ".zst") {
    name = name.stem();
  }
  WorldsResult read = read_any(path, name, frame);
  WorldsResult result;
  result.diagnostics = std::move(read.diagnostics);
  const bool alone = read.worlds.size() == 1;
  std::set<std::string> names;
  for (World& world : read.worlds) {
    if (world.name.empty() || (alone && world.name == "#0")) {
      world.name = name.stem().string();
    }
    std::vector<std::string> problems = world_problems(world);
    if (!names.insert(world.name).second) {
      problems.emplace_back("a name of its own");
    }
    for (const std::string& problem : problems) {
      result.diagnostics.push_back({table::Severity::error,
                                    path.string(),
                                    0,
                                    "",
                                    "",
                                    "of world '" + table::shortened(world.name) + "' " + problem,
                                    1});
    }
    if (problems.empty()) {
      result.worlds.push_back(std::move(world));
    }
  }
  return result;
}

}  // namespace tcert
