#include <table/json_shape.hpp>

#include <gtest/gtest.h>

#include <string>
#include <table/diagnostic.hpp>
#include <table/flat_json.hpp>
#include <table/json_object.hpp>

#include "datasets/world.hpp"

namespace tcert::table {
namespace {

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(JsonShape, CountsWhatIsOpenAtOnce) {
  EXPECT_EQ(json_shape_problem(nested(64)), "");
  EXPECT_EQ(json_shape_problem(nested(65)), kNestedTooDeeply);
  std::string flat = "[";
  for (int i = 0; i < 1000; ++i) {
    flat += "{\"a\":[]},";
  }
  EXPECT_EQ(json_shape_problem(flat + "0]"), "");
}

TEST(JsonShape, DoesNotCountWhatIsWithinATextOrCutShort) {
  EXPECT_EQ(json_shape_problem("\"" + std::string(1000, '[') + "\""), "");
  EXPECT_EQ(json_shape_problem("[\"\\\"" + std::string(1000, '{') + "\"]"), "");
  EXPECT_EQ(json_shape_problem(std::string(1'000'000, '{')), kNestedTooDeeply);
  EXPECT_EQ(json_shape_problem("\"\\"), "");
}

std::string with_keys(std::size_t count) {
  std::string text = "{\"k\":0";
  for (std::size_t i = 1; i < count; ++i) {
    text += ",\"k" + std::to_string(i) + "\":1";
  }
  return text + "}";
}

TEST(JsonShape, CountsTheKeysOfEachObject) {
  EXPECT_EQ(json_shape_problem(with_keys(4096)), "");
  EXPECT_EQ(json_shape_problem(with_keys(4097)), kTooManyKeys);
  EXPECT_EQ(json_shape_problem("[" + with_keys(4096) + "," + with_keys(4096) + "]"), "");
  EXPECT_EQ(json_shape_problem("[{\"a\":" + with_keys(4097) + "}]"), kTooManyKeys);
  EXPECT_EQ(json_shape_problem("\"" + std::string(5000, ':') + "\""), "");
  EXPECT_THROW((void)world_from_json(with_keys(200'000)), WorldFormatError);
}

TEST(JsonShape, IsAnErrorOfADocument) {
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
