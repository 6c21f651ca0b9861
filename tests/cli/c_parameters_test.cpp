#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "analysis/study/trials/parameters.hpp"

namespace tcert {
namespace {

bool begins_with(std::string_view text, std::string_view prefix) {
  return text.substr(0, prefix.size()) == prefix;
}

// Whoever adds a parameter adds it to the C interface too, under the same name.
TEST(CParameters, AreAllThatTheLiveLoopHas) {
  std::ifstream file(TCERT_GOLDEN "/../../lib/control/tcert/tcert.h");
  const std::string header{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  ASSERT_FALSE(header.empty());
  int found = 0;
  for (const study::ParameterInfo& parameter : study::parameter_table()) {
    const bool of_live_loop =
        parameter.stage == study::Stage::certify ||
        (parameter.stage == study::Stage::control && !begins_with(parameter.key, "route_") &&
         !begins_with(parameter.key, "replay_") && !begins_with(parameter.key, "unsafe_"));
    if (of_live_loop) {
      EXPECT_NE(header.find(" " + std::string(parameter.key) + ";"), std::string::npos)
          << parameter.key;
      ++found;
    }
  }
  EXPECT_GT(found, 30);
}

}  // namespace
}  // namespace tcert
