#include "cli/runs/world.hpp"

#include "cli/commands/field_listing.hpp"
#include "cli/commands/run_command.hpp"
#include "datasets/world_fields.hpp"

namespace tcert::cli {
namespace {

constexpr std::string_view kWorldText =
    R"(The truth of known worlds: the best margin that any path from S to G has.

T is the largest value, over all paths, of min(clearance slack, turn radius - least turn radius).
Printed as an interval: at least what a path that was found and measured is worth, at most what the
clearance alone allows, which is exact for fields of discs and within a stated error for others.

Files: .json or .jsonl (the worlds of a bundle; one, an array, one a line), .csv of discs
(world,x_m,y_m,radius_m), .map of MovingAI, .yaml of ROS map_server with its PGM or PNG image, turned or not (unknown is
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

/// With the file of our own format, key by key, which no other text has.
std::string help() {
  std::string text(kWorldText);
  text +=
      "\nThe world file, version 1, is a JSON object (* is required; another key is an error):\n";
  return text + fields_in_words(world_fields()) +
         "Lengths are in metres, in one frame for the whole world, x and y at right angles. No "
         "path "
         "leaves the\nbounds; a polygon is simple, and closed by itself.\n";
}

int run_world(Arguments arguments) { return run_command(help(), arguments, world); }

std::vector<CommandForm> world_forms() { return {form_for<WorldRequest>(help())}; }

}  // namespace

const Command kWorld = {
    "world", "the truth of known worlds: the best margin a path has", run_world, world_forms};

}  // namespace tcert::cli
