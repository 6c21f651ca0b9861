#include "datasets/world.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tcert {
namespace {

World some_world() {
  World world;
  world.name = "a";
  world.synthetic = true;
  world.seed = 18446744073709551615U;
  world.bounds = {{-1.0, -2.0}, {3.0, 4.1}};
  world.obstacles = {Disc{{0.1, 0.2}, 1.0 / 3.0}, Polygon{{{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.1}}}};
  world.start = Disc{{2.0, 2.0}, 0.25};
  world.goal = Polygon{{{0.0, 3.0}, {1.0, 3.0}, {1.0, 4.0}}};
  return world;
}

TEST(World, ReadsBackAsItWasWritten) {
  const World world = some_world();
  const World read = world_from_json(to_json(world));
  EXPECT_EQ(to_json(read), to_json(world));
  EXPECT_EQ(read.seed, world.seed);
  EXPECT_EQ(std::get<Disc>(read.obstacles[0]).radius_m, 1.0 / 3.0);
  EXPECT_EQ(std::get<Polygon>(read.obstacles[1]).vertices[2], (Point{0.5, 0.1}));
  EXPECT_TRUE(read.start.has_value());
  EXPECT_TRUE(read.goal.has_value());
}

TEST(World, SaysFirstWhetherItIsSynthetic) {
  EXPECT_EQ(to_json(some_world()).rfind("{\"synthetic\":true,\"seed\":", 0), 0U);
}

TEST(World, NamesWhatIsWrong) {
  const std::string good = to_json(some_world());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const auto message = [](const std::string& text) -> std::string {
    try {
      (void)world_from_json(text);
    } catch (const WorldFormatError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message(good), "accepted");
  EXPECT_NE(message(good.substr(0, 40)).find("not JSON"), std::string::npos);
  EXPECT_EQ(message(with("\"bounds\"", "\"bound\"")), "world: expected no key 'bound'");
  EXPECT_EQ(message(with("\"version\":1", "\"version\":2")), "version: expected 1");
  EXPECT_EQ(message(with("\"high\":[3.0", "\"high\":[-3.0")),
            "bounds: expected low below high in both axes");
  EXPECT_EQ(message(with("\"radius_m\":0.33", "\"radius_m\":-0.33")),
            "obstacles[0]: expected a positive radius_m");
  EXPECT_EQ(message(with("[0.0,0.0],", "")),
            "obstacles[1]: expected a polygon of at least 3 vertices");
  EXPECT_EQ(message(with("\"x_m\":0.1", "\"x_m\":\"left\"")),
            "obstacles[0]: expected a finite number");
}

}  // namespace
}  // namespace tcert
