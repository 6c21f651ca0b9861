#pragma once
/// \file
/// Worlds from files of any of the formats.

#include <filesystem>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/world.hpp"

namespace tcert {

/// What a file of a foreign format does not say.
struct WorldFrame {
  std::optional<Bounds> bounds;  ///< Of a field of discs; else what holds the discs, S and G.
  std::optional<Region> start;   ///< Goes before the world's own.
  std::optional<Region> goal;
  double cell_m = 1.0;  ///< Side of a cell of a MovingAI map.
};

/// Worlds in the order of the file. One with a problem is left out and named in the diagnostics,
/// whose `column` is the world's name; the others go on.
struct WorldsResult {
  std::vector<World> worlds;
  std::vector<table::Diagnostic> diagnostics;
};

/// The tool's own JSON: one world, an array of worlds, or one a line.
[[nodiscard]] WorldsResult worlds_from_json(const table::Bytes& bytes, const std::string& file);

/// CSV with columns world, x_m, y_m, radius_m: a row a disc; rows of a world may lie anywhere.
[[nodiscard]] WorldsResult worlds_from_disc_csv(const table::Bytes& bytes,
                                                const std::string& file,
                                                const WorldFrame& frame);

/// MovingAI (Sturtevant, 2012): 'type octile', height, width, map; or MapWidth=, MapHeight=,
/// MapData. '.', 'G' and 'S' are free, '@', 'O', 'T' and 'W' are not, unless header lines 'free .'
/// or 'obstacle @' say otherwise of a sign; a line 'map' may be missing. The first row lies at high
/// y, the low corner at the origin.
[[nodiscard]] WorldsResult world_from_moving_ai(const table::Bytes& bytes,
                                                const std::string& file,
                                                const WorldFrame& frame);

/// An image as map_server of ROS reads it.
struct RosMap {
  std::string image;  ///< Path as the YAML has it.
  double resolution_m = 0.0;
  Point origin;          ///< Low corner of the image's last row.
  double yaw_rad = 0.0;  ///< The image is turned by so much about it, counter-clockwise.
  bool negate = false;
  double occupied_threshold = 0.65;
  double free_threshold = 0.196;
};

/// image, resolution, origin [x, y, yaw] (or a line each), negate, occupied_thresh, free_thresh;
/// mode trinary. Another key is a warning and has no effect.
[[nodiscard]] std::optional<RosMap> read_ros_yaml(const table::Bytes& bytes,
                                                  const std::string& file,
                                                  std::vector<table::Diagnostic>& diagnostics);

/// p = (max - x) / max, or x / max with `negate`; free iff p < free_threshold: unknown is occupied.
/// The image is a PGM, P2 or P5, or a PNG, of which colours count by their luminance. A turned map
/// is given in its own axes: S and G are turned back about the origin, which a warning says.
[[nodiscard]] WorldsResult world_from_image(const table::Bytes& bytes,
                                            const std::string& file,
                                            const RosMap& map,
                                            const WorldFrame& frame);

/// By the name: .json, .jsonl, .csv, .map, .yaml or .yml (with the image it names), each also with
/// .gz or .zst. Worlds that cannot be asked for their truth (world_problems) are left out with an
/// error.
[[nodiscard]] WorldsResult read_worlds(const std::filesystem::path& path,
                                       const WorldFrame& frame = {});

}  // namespace tcert
