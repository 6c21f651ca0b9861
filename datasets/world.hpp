#pragma once
/// \file
/// A known world: its walls and its access and egress regions, and the file that holds them.

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tcert/region.hpp>
#include <vector>

namespace tcert {

/// Axis-parallel rectangle. Nothing outside the bounds of a world is free.
struct Bounds {
  Point low;
  Point high;
};

/// Free space is the bounds less the obstacles, which may touch and overlap.
struct World {
  std::string name;
  bool synthetic = false;
  std::optional<std::uint64_t> seed;  ///< Of the generator, if synthetic.
  Bounds bounds;
  std::vector<Region> obstacles;  ///< Discs and simple polygons.
  std::optional<Region> start;    ///< S.
  std::optional<Region> goal;     ///< G.
};

/// The text of a world file is not a world. what() names the member and what was expected.
class WorldFormatError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One JSON object of format "tcert-world", version 1, "synthetic" first; ends with a newline.
/// Numbers are written in shortest round-trip form, so reading back gives the same world.
[[nodiscard]] std::string to_json(const World& world);

/// \throws WorldFormatError on anything that to_json does not write: unknown keys, numbers that are
/// not finite, bounds of no area, radii that are not positive, polygons of fewer than 3 vertices.
[[nodiscard]] World world_from_json(std::string_view text);

}  // namespace tcert
