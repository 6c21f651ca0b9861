// Any bytes as a file of worlds, in every format: never a throw; worlds or an error; and a world
// that is read is written and read back as the same.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "datasets/worlds/world_files.hpp"
#include "datasets/worlds/world_problems.hpp"
#include "fuzz/check.hpp"

namespace {

void check(const tcert::WorldsResult& result) {
  using namespace tcert;
  fuzz::require(!result.worlds.empty() || table::has_error(result.diagnostics),
                "no worlds means an error");
  for (const table::Diagnostic& diagnostic : result.diagnostics) {
    fuzz::require(table::to_string(diagnostic).find('\n') == std::string::npos,
                  "a message is one line");
  }
  for (const World& world : result.worlds) {
    if (world.obstacles.size() < 100) {
      (void)world_problems(world);
    }
  }
}

}  // namespace

// The first byte chooses the format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tcert;
  if (size == 0) {
    return 0;
  }
  const table::Bytes bytes =
      table::Bytes::copy_of({reinterpret_cast<const char*>(data + 1), size - 1});
  switch (data[0]) {
    case 'j': {
      const WorldsResult read = worlds_from_json(bytes, "f");
      check(read);
      for (const World& world : read.worlds) {
        const std::string text = to_json(world);
        fuzz::require(to_json(world_from_json(text)) == text,
                      "what is written reads back the same");
      }
      break;
    }
    case 'c':
      check(worlds_from_disc_csv(bytes, "f", {}));
      break;
    case 'm':
      check(world_from_moving_ai(bytes, "f", {}));
      break;
    case 'p': {
      RosMap map;
      map.resolution_m = 0.05;
      check(world_from_image(bytes, "f", map, {}));
      break;
    }
    default: {
      std::vector<table::Diagnostic> problems;
      const auto map = read_ros_yaml(bytes, "f", problems);
      fuzz::require(map.has_value() != table::has_error(problems),
                    "rejected iff there is an error");
      break;
    }
  }
  return 0;
}
