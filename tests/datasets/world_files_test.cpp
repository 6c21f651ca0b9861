#include "datasets/worlds/world_files.hpp"
#include "datasets/png_image.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include "datasets/worlds/region_distance.hpp"
#include "datasets/worlds/world_problems.hpp"
#include "support/temporary_folder.hpp"

namespace tcert {
namespace {

using test_support::TemporaryFolder;

WorldFrame frame() {
  WorldFrame frame;
  frame.start = Disc{{0.5, 0.5}, 0.2};
  frame.goal = Disc{{3.5, 0.5}, 0.2};
  return frame;
}

/// The only diagnostic of a file that is refused.
std::string refusal(const WorldsResult& result) {
  if (!result.worlds.empty() || result.diagnostics.size() != 1) {
    return "worlds: " + std::to_string(result.worlds.size()) +
           ", diagnostics: " + std::to_string(result.diagnostics.size());
  }
  return table::to_string(result.diagnostics.front());
}

std::string refused_map(std::string_view text) {
  return refusal(world_from_moving_ai(table::Bytes::copy_of(text), "m.map", frame()));
}

#define EXPECT_HAS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(WorldFiles, OneJsonOrManyInOneFile) {
  TemporaryFolder folder;
  World world;
  world.bounds = {{0.0, 0.0}, {4.0, 1.0}};
  world.start = frame().start;
  world.goal = frame().goal;
  world.obstacles.emplace_back(Disc{{2.0, 0.5}, 0.1});
  world.name = "one";
  const std::string one = to_json(world);
  world.name = "two";
  const std::string two = to_json(world);
  EXPECT_EQ(read_worlds(folder.write("a.json", one)).worlds.size(), 1U);
  for (const auto& [name, text] : {std::pair<const char*, std::string>{"b.jsonl", one + "\n" + two},
                                   {"c.json", "[" + one + "," + two + "]"}}) {
    const WorldsResult read = read_worlds(folder.write(name, text));
    ASSERT_EQ(read.worlds.size(), 2U) << name;
    EXPECT_EQ(read.worlds[1].name, "two");
    EXPECT_TRUE(read.diagnostics.empty());
  }
  const WorldsResult twice = read_worlds(folder.write("d.jsonl", one + one));
  EXPECT_EQ(twice.worlds.size(), 1U);
  ASSERT_EQ(twice.diagnostics.size(), 1U);
  EXPECT_HAS(table::to_string(twice.diagnostics.front()), "'one' a name of its own");
  const WorldsResult mixed = read_worlds(folder.write("e.jsonl", "{\"format\": 1}\n" + two));
  EXPECT_EQ(mixed.worlds.size(), 1U);
  ASSERT_EQ(mixed.diagnostics.size(), 1U);
  EXPECT_HAS(table::to_string(mixed.diagnostics.front()), "e.jsonl:1: error");
}

TEST(WorldFiles, DiscsByWorldWithTheirLines) {
  const WorldsResult read = worlds_from_disc_csv(
      table::Bytes::copy_of(
          "world,x_m,y_m,radius_m\na,2,0.5,0.1\nb,2,0.1,0.1\na,2,0.9,0.1\nc,2,0,-1\n"),
      "d.csv",
      frame());
  ASSERT_EQ(read.worlds.size(), 2U);
  EXPECT_EQ(read.worlds[0].name, "a");
  EXPECT_EQ(read.worlds[0].obstacles.size(), 2U);
  EXPECT_DOUBLE_EQ(read.worlds[0].bounds.low.x_m, 0.3);  // S ends there
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_HAS(table::to_string(read.diagnostics.front()),
             "d.csv:5: error: column 'radius_m': found '-1'");
  EXPECT_HAS(table::to_string(read.diagnostics.front()), "world 'c' is left out");
}

TEST(WorldFiles, MovingAiMapsOfBothHeaders) {
  for (const char* const header :
       {"type octile\nheight 2\nwidth 4\nmap\n", "MapWidth=4\nMapHeight=2\nMapData \n"}) {
    const WorldsResult read = world_from_moving_ai(
        table::Bytes::copy_of(std::string(header) + "@@.@\n....\n"), "m.map", frame());
    ASSERT_EQ(read.worlds.size(), 1U) << refusal(read);
    const World& world = read.worlds.front();
    EXPECT_EQ(world.bounds.high, (Point{4.0, 2.0}));
    ASSERT_EQ(world.obstacles.size(), 2U);  // the first row lies at high y
    EXPECT_EQ(region_distance(world.obstacles[0], {1.0, 1.5}), 0.0);
    EXPECT_EQ(region_distance(world.obstacles[1], {3.5, 1.5}), 0.0);
  }
}

TEST(WorldFiles, MapsWhoseHeaderLies) {
  const std::string head = "type octile\nheight 2\nwidth 4\nmap\n";
  EXPECT_HAS(refused_map(head + "....\n"), "2 rows, as the header says, but there are 1");
  EXPECT_HAS(refused_map(head + "....\n...\n"), "m.map:6: error");
  EXPECT_HAS(refused_map(head + "....\n.x..\n"), "cells of . G S");
  const std::string map = head + "....\n....\n";
  EXPECT_HAS(refused_map(map + map), "one map a file");
  EXPECT_HAS(refused_map("type octile\nheight 0\nwidth 4\nmap\n"), "above 0");
  EXPECT_HAS(refused_map("height 99999999999\nwidth 99999999999\nmap\n"), "100 million");
  EXPECT_HAS(refused_map(""), "'map' or 'MapData'");
}

RosMap ros_map(bool negate = false) {
  RosMap map;
  map.image = "m.pgm";
  map.resolution_m = 0.5;
  map.origin = {-1.0, 2.0};
  map.negate = negate;
  return map;
}

TEST(WorldFiles, RosMapsPlainAndRaw) {
  const std::string raw("P5\n# a comment\n3 1\n255\n\xfe\xcd\x00", 26);
  for (const std::string& text : {std::string("P2\n3 1 # wide\n255\n254 205 0\n"), raw}) {
    const WorldsResult read =
        world_from_image(table::Bytes::copy_of(text), "m.pgm", ros_map(), frame());
    ASSERT_EQ(read.worlds.size(), 1U) << refusal(read);
    const World& world = read.worlds.front();
    EXPECT_EQ(world.bounds.low, (Point{-1.0, 2.0}));
    EXPECT_EQ(world.bounds.high, (Point{0.5, 2.5}));
    ASSERT_EQ(world.obstacles.size(), 1U);  // unknown (205) and occupied, side by side
    const Extent extent = extent_of(world.obstacles.front());
    EXPECT_EQ(extent.low, (Point{-0.5, 2.0}));
    EXPECT_EQ(extent.high, (Point{0.5, 2.5}));
  }
  const WorldsResult negated =
      world_from_image(table::Bytes::copy_of("P2 2 1 255 255 0"), "m.pgm", ros_map(true), frame());
  ASSERT_EQ(negated.worlds.size(), 1U);
  EXPECT_EQ(extent_of(negated.worlds[0].obstacles.at(0)).low, (Point{-1.0, 2.0}));
}

TEST(WorldFiles, RosMapsWhoseHeaderLies) {
  const auto refused = [](std::string_view text) {
    return refusal(world_from_image(table::Bytes::copy_of(text), "m.pgm", ros_map(), frame()));
  };
  EXPECT_HAS(refused("P2 2 2 255 0 0 0"), "pixel 3 is missing");
  EXPECT_HAS(refused("P2 2 1 255 0 0 0"), "one map a file");
  EXPECT_HAS(refused("P5 2 1 255\nabc"), "in 2 bytes, but there are 3");
  EXPECT_HAS(refused("P5 2 1 255\naP5 2 1 255\nab"), "but there are");
  EXPECT_HAS(refused("P6 2 1 255\nab"), "P2 or P5");
  EXPECT_HAS(refused("P2 0 1 255\n"), "above 0");
}

TEST(WorldFiles, RosYamlIsReadStrictly) {
  std::vector<table::Diagnostic> problems;
  const auto map = read_ros_yaml(
      table::Bytes::copy_of("image: \"a b.pgm\"\nresolution: 0.05  # m\norigin: [-1.5, 2, 0.0]\n"
                            "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"),
      "m.yaml",
      problems);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->image, "a b.pgm");
  EXPECT_EQ(map->origin, (Point{-1.5, 2.0}));
  EXPECT_EQ(map->free_threshold, 0.25);
  EXPECT_FALSE(read_ros_yaml(
      table::Bytes::copy_of("image: a.pgm\nresolution: 0\norigin: [0, 0, x]\nnegat: 0\n"),
      "m.yaml",
      problems));
  ASSERT_EQ(problems.size(), 3U);
  EXPECT_HAS(table::to_string(problems[0]), "m.yaml:2: error: column 'resolution'");
  EXPECT_HAS(table::to_string(problems[1]), "[x, y, yaw]");
  EXPECT_HAS(table::to_string(problems[2]), "m.yaml:4: warning: column 'negat'");
}

TEST(WorldFiles, RosYamlTakesListsALineEachAndKeysThatItDoesNotKnow) {
  std::vector<table::Diagnostic> problems;
  const auto map = read_ros_yaml(
      table::Bytes::copy_of(
          "image: m.pgm\nresolution: 0.05\norigin:\n- -10.5\n  - 2\n-   0.0\nnegate: 0\n"
          "cost_scale: 3\nlayers:\n  - a\n"),
      "m.yaml",
      problems);
  ASSERT_TRUE(map) << table::to_string(problems.at(0));
  EXPECT_EQ(map->origin, (Point{-10.5, 2.0}));
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_HAS(table::to_string(problems[0]), "m.yaml:8: warning: column 'cost_scale'");
  EXPECT_HAS(table::to_string(problems[1]), "m.yaml:9: warning: column 'layers'");
  const auto turned = read_ros_yaml(
      table::Bytes::copy_of("image: m.pgm\nresolution: 1\norigin:\n- 1\n- 2\n- 0.7\n"),
      "m.yaml",
      problems);
  ASSERT_TRUE(turned);
  EXPECT_EQ(0.7, turned->yaw_rad);
}

TEST(WorldFiles, TurnedMapsTurnStartAndGoalBack) {
  RosMap map = ros_map();
  map.yaw_rad = 1.5707963267948966;
  WorldFrame turned = frame();
  // A quarter turn about (-1, 2): what lies one metre north of it lies one metre along the rows.
  turned.start = Disc{{-1.0, 3.0}, 0.1};
  const WorldsResult read =
      world_from_image(table::Bytes::copy_of("P2 3 1 255 254 254 254"), "m.pgm", map, turned);
  ASSERT_EQ(read.worlds.size(), 1U);
  const auto disc = std::get<Disc>(*read.worlds[0].start);
  EXPECT_NEAR(disc.centre.x_m, 0.0, 1e-12);
  EXPECT_NEAR(disc.centre.y_m, 2.0, 1e-12);
  EXPECT_EQ(disc.radius_m, 0.1);
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_HAS(table::to_string(read.diagnostics[0]), "in its own axes");
}

TEST(WorldFiles, PngMapsAreThoseOfTheSamePgm) {
  const std::string png = png_bytes({3, 2, 1, {254, 205, 0, 254, 254, 10}});
  const WorldsResult a = world_from_image(table::Bytes::copy_of(png), "m.png", ros_map(), frame());
  const WorldsResult b = world_from_image(
      table::Bytes::copy_of("P2 3 2 255 254 205 0 254 254 10"), "m.pgm", ros_map(), frame());
  ASSERT_EQ(a.worlds.size(), 1U) << refusal(a);
  EXPECT_EQ(to_json(a.worlds[0]), to_json(b.worlds[0]));
  // What is cut off is refused, unless it was the end mark alone.
  for (std::size_t cut = 9; cut < png.size(); ++cut) {
    const WorldsResult part =
        world_from_image(table::Bytes::copy_of(png.substr(0, cut)), "m.png", ros_map(), frame());
    if (part.worlds.empty()) {
      EXPECT_HAS(refusal(part), "PNG image that is whole");
    } else {
      EXPECT_GT(cut, png.size() - 20);
      EXPECT_EQ(to_json(part.worlds[0]), to_json(b.worlds[0]));
    }
  }
}

std::string png_chunk(const std::string& type, const std::string& data) {
  const auto four = [](std::uint64_t v) {
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) {
      text += static_cast<char>((v >> shift) & 0xffU);
    }
    return text;
  };
  const std::string body = type + data;
  return four(data.size()) + body +
         four(
             crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size())));
}

/// One row of pixels, each line of bytes with its filter 0 in front.
std::string png_row(int width, int depth, int kind, const std::string& bytes, bool linear) {
  const std::string raw = std::string(1, '\0') + bytes;
  std::string packed(compressBound(static_cast<uLong>(raw.size())), '\0');
  auto size = static_cast<uLongf>(packed.size());
  compress(reinterpret_cast<Bytef*>(packed.data()),
           &size,
           reinterpret_cast<const Bytef*>(raw.data()),
           static_cast<uLong>(raw.size()));
  packed.resize(size);
  std::string header(13, '\0');
  header[3] = static_cast<char>(width);
  header[7] = 1;
  header[8] = static_cast<char>(depth);
  header[9] = static_cast<char>(kind);
  return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) +
         (linear ? png_chunk("gAMA", std::string("\0\1\x86\xa0", 4)) : std::string()) +
         png_chunk("IDAT", packed) + png_chunk("IEND", "");
}

/// The numbers of the file decide, whatever gamma they have; transparent is unknown.
TEST(WorldFiles, PngMapsOfOtherKindsKeepTheirNumbers) {
  using namespace std::string_literals;
  const auto pixels = [](const std::string& png) { return read_png(png, 100).image.pixels; };
  const std::vector<std::uint8_t> grey{100, 100, 100, 255, 220, 220, 220, 255};
  EXPECT_EQ(grey, pixels(png_row(2, 8, 0, "\x64\xdc", false)));
  EXPECT_EQ(grey, pixels(png_row(2, 8, 0, "\x64\xdc", true)));
  EXPECT_EQ(grey, pixels(png_row(2, 16, 0, "\x64\x64\xdc\xdc", false)));
  EXPECT_EQ(grey, pixels(png_row(2, 16, 0, "\x64\x64\xdc\xdc", true)));
  const auto world_of = [](const std::string& image, const std::string& name) {
    const WorldsResult read =
        world_from_image(table::Bytes::copy_of(image), name, ros_map(), frame());
    EXPECT_EQ(1U, read.worlds.size());
    return read.worlds.empty() ? std::string() : to_json(read.worlds[0]);
  };
  // 170 on average is occupied, though its luminance is 236; white that is transparent is no floor.
  EXPECT_EQ(
      world_of(png_row(3, 8, 6, "\xff\xff\0\xff\xff\xff\xff\0\xfe\xfe\xfe\xff"s, false), "m.png"),
      world_of("P2 3 1 255 170 0 254", "m.pgm"));
  std::string broken = png_row(2, 8, 0, "\x64\xdc", true);
  broken[8] = '\xff';  // A first chunk of 4 GB.
  EXPECT_NE("", read_png(broken, 100).problem);
  EXPECT_NE("", read_png("\x89PNG", 100).problem);
}

TEST(WorldFiles, ImagesThatAreNoPgmAreNamed) {
  using namespace std::string_view_literals;
  const std::string text = refusal(world_from_image(
      table::Bytes::copy_of("\x89PNG\r\n\x1a\n\0\0"sv), "m.png", ros_map(), frame()));
  EXPECT_HAS(text, "a PNG image that is whole");
  TemporaryFolder folder;
  EXPECT_HAS(refusal(read_worlds(folder.write("a.map", "\x89PNG\r\n\x1a\n\0\0"sv))), "a PNG image");
}

TEST(WorldFiles, MovingAiHeadersThatSayWhatIsFree) {
  const auto read = [](const std::string& signs, const std::string& cells) {
    return world_from_moving_ai(
        table::Bytes::copy_of("height 2\nwidth 4\n" + signs + "map\n" + cells), "m.map", frame());
  };
  const WorldsResult usual = read("free .\nobstacle @\n", "@@.@\n....\n");
  ASSERT_EQ(usual.worlds.size(), 1U) << refusal(usual);
  EXPECT_EQ(usual.worlds[0].obstacles.size(), 2U);
  // Signs of their own, and one whose meaning is turned round.
  const WorldsResult own = read("free _ @\nobstacle # .\n", "##_#\n_@@_\n");
  ASSERT_EQ(own.worlds.size(), 1U) << refusal(own);
  EXPECT_EQ(own.worlds[0].obstacles.size(), 2U);
  const WorldsResult no_map = world_from_moving_ai(
      table::Bytes::copy_of("height 3\nwidth 4\nfree .\nobstacle @\n....\n.@@.\n....\n"),
      "m.map",
      frame());
  ASSERT_EQ(no_map.worlds.size(), 1U) << refusal(no_map);
  EXPECT_EQ(no_map.worlds[0].obstacles.size(), 1U);
  EXPECT_HAS(refusal(read("free #\nobstacle #\n", "....\n....\n")), "either free or an obstacle");
  EXPECT_HAS(refusal(read("free\n", "....\n....\n")), "a sign after");
}

World world() {
  World result;
  result.name = "w";
  result.bounds = {{0.0, 0.0}, {4.0, 2.0}};
  result.start = Disc{{0.5, 1.0}, 0.2};
  result.goal = Disc{{3.5, 1.0}, 0.2};
  result.obstacles.emplace_back(Polygon{{{1.5, 0.0}, {2.5, 0.0}, {2.5, 0.8}, {1.5, 0.8}}});
  return result;
}

void expect_problem(const World& bad, std::string_view part) {
  const std::vector<std::string> problems = world_problems(bad);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_HAS(problems.front(), part);
}

TEST(WorldProblems, NamesWhatIsWrong) {
  EXPECT_TRUE(world_problems(world()).empty());
  World bad = world();
  bad.obstacles.clear();
  expect_problem(bad, "world is empty");
  bad = world();
  bad.obstacles.emplace_back(Polygon{{{1.0, 1.5}, {2.0, 1.9}, {2.0, 1.5}, {1.0, 1.9}}});
  expect_problem(bad, "of obstacles[1] crosses");
  bad = world();
  bad.goal = Disc{{2.0, 0.4}, 0.1};
  expect_problem(bad, "a goal free of obstacles, but it touches obstacles[0]");
  bad = world();
  bad.start = Disc{{2.0, 0.6}, 0.5};  // the obstacle's corners lie outside of it
  expect_problem(bad, "a start free of obstacles");
  bad = world();
  bad.goal = Disc{{0.6, 1.1}, 0.2};
  expect_problem(bad, "overlap");
  bad = world();
  bad.start = Polygon{{{-0.1, 0.5}, {0.5, 0.5}, {0.5, 1.0}}};
  expect_problem(bad, "inside the bounds");
  bad = world();
  bad.goal.reset();
  expect_problem(bad, "a goal");
}

TEST(WorldFiles, ABadWorldIsNamedAndTheOthersGoOn) {
  TemporaryFolder folder;
  const auto path = folder.write("w.csv",
                                 "world,x_m,y_m,radius_m\n"
                                 "in-start,0.5,0.5,0.1\n"
                                 "good,2,0.5,0.1\n");
  const WorldsResult read = read_worlds(path, frame());
  ASSERT_EQ(read.worlds.size(), 1U);
  EXPECT_EQ(read.worlds.front().name, "good");
  ASSERT_EQ(read.diagnostics.size(), 1U);
  EXPECT_HAS(table::to_string(read.diagnostics.front()),
             "of world 'in-start' a start free of obstacles");
}

}  // namespace
}  // namespace tcert
