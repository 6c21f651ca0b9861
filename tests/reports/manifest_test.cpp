#include "reports/manifest.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace tcert {
namespace {

Manifest example() {
  Manifest manifest;
  manifest.command = "certify";
  manifest.options = {{"trials", ""}, {"strict", "false"}, {"effect", "0.5"}};
  manifest.parameters = {{"edge_length_m", "0.25"}, {"curvature", "path"}};
  manifest.seed = 18446744073709551615ULL;
  manifest.synthetic = SyntheticLabel{1};
  manifest.inputs = {{"corpus/bundle.json", {1, 3, sha256("abc")}}};
  return manifest;
}

TEST(Manifest, WritesNumbersAsNumbersAndTheAbsentAsNull) {
  const auto json = nlohmann::json::parse(to_json(example()));
  EXPECT_EQ(json["format"], "tcert-manifest");
  EXPECT_EQ(json["synthetic"], true);
  EXPECT_EQ(json["synthetic_seed"], 1);
  EXPECT_EQ(json["seed"], 18446744073709551615ULL);
  EXPECT_TRUE(json["options"]["trials"].is_null());
  EXPECT_EQ(json["options"]["strict"], false);
  EXPECT_EQ(json["options"]["effect"], 0.5);
  EXPECT_EQ(json["parameters"]["edge_length_m"], 0.25);
  EXPECT_EQ(json["parameters"]["curvature"], "path");
  EXPECT_EQ(json["inputs"][0]["sha256"], sha256("abc"));
  EXPECT_FALSE(json["tool"]["version"].get<std::string>().empty());
  EXPECT_FALSE(json["tool"]["commit"].get<std::string>().empty());
}

TEST(Manifest, IsTheSameForTheSameFacts) { EXPECT_EQ(to_json(example()), to_json(example())); }

TEST(NameOf, IsThatOfTheFolderItselfForADot) {
  const std::string here = std::filesystem::current_path().filename().string();
  EXPECT_EQ(name_of("."), here);
  EXPECT_EQ(name_of("./"), here);
  EXPECT_EQ(name_of("x/.."), here);
  EXPECT_EQ(name_of("a/corpus/"), "corpus");
  EXPECT_EQ(name_of("a/corpus"), "corpus");
  EXPECT_EQ(name_of(""), "");
}

}  // namespace
}  // namespace tcert
