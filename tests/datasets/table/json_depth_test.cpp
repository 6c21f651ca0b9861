#include <table/json_depth.hpp>

#include <gtest/gtest.h>

#include <string>
#include <table/diagnostic.hpp>
#include <table/flat_json.hpp>
#include <table/json_object.hpp>

#include "datasets/world.hpp"

namespace tcert::table {
namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonDepth, CountsWhatIsOpenAtOnce) {
  EXPECT_FALSE(is_nested_too_deeply(nested(64)));
  EXPECT_TRUE(is_nested_too_deeply(nested(65)));
  std::string flat = "[";
  for (int i = 0; i < 1000; ++i) {
    flat += "{\"a\":[]},";
  }
  EXPECT_FALSE(is_nested_too_deeply(flat + "0]"));
}

TEST(JsonDepth, DoesNotCountWhatIsWithinATextOrCutShort) {
  EXPECT_FALSE(is_nested_too_deeply("\"" + std::string(1000, '[') + "\""));
  EXPECT_FALSE(is_nested_too_deeply("[\"\\\"" + std::string(1000, '{') + "\"]"));
  EXPECT_TRUE(is_nested_too_deeply(std::string(1'000'000, '{')));
  EXPECT_FALSE(is_nested_too_deeply("\"\\"));
}

TEST(JsonDepth, IsAnErrorOfADocument) {
  DiagnosticGroups problems;
  EXPECT_FALSE(parse_json("{\"a\":" + nested(100'000) + "}", "bundle.json", problems));
  const auto found = problems.take();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(to_string(found[0]).find("nested too deeply"), std::string::npos);
  EXPECT_THROW((void)world_from_json(nested(100'000)), WorldFormatError);
}

TEST(FlatJson, TakesTimeInProportionToItsKeysAndSeesARepeatedOne) {
  std::string text = "{";
  for (int i = 0; i < 200'000; ++i) {
    text += "\"k" + std::to_string(i) + "\":1,";
  }
  const auto members = parse_flat_json(text + "\"last\":2}");
  ASSERT_TRUE(members);
  EXPECT_EQ(members->size(), 200'001U);
  EXPECT_FALSE(parse_flat_json(text + "\"k7\":2}"));
  EXPECT_FALSE(parse_flat_json("{\"a\":1,\"a\":2}"));
}

}  // namespace
}  // namespace tcert::table
