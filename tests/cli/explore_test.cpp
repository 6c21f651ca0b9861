#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/temporary_folder.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

/// The configuration as its authors print it.
constexpr std::string_view kPrinted = R"([environment]
FILENAME = "terrain.csv"
THRESHOLD = 1000
SIMPLIFICATION_CONSTANT = 4

[robot]
ROBOT_RADIUS = 2
MODE = "navigate"

[optimization]

NUM_EXPANDERS = 40
KERNEL_VARIANCE = 2
KERNEL_LENGTHSCALE = 30
BETA = 3
LIPSCHITZ = 0.003

[display]

BUFFER_SIZE = 1
)";

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(std::string::npos, text.find(part)) << text << "\nlacks: " << part;
}

/// A cell of a column of the last row of a CSV text.
std::string last_of(const std::string& csv, const std::string& column) {
  const auto cells = [](const std::string& line) {
    std::vector<std::string> parts(1);
    for (const char c : line) {
      if (c == ',') {
        parts.emplace_back();
      } else {
        parts.back() += c;
      }
    }
    return parts;
  };
  const auto header = cells(csv.substr(0, csv.find('\n')));
  const std::string rows = csv.substr(0, csv.size() - 1);
  const auto last = cells(rows.substr(rows.rfind('\n') + 1));
  for (std::size_t k = 0; k < header.size(); ++k) {
    if (header[k] == column) {
      return last.at(k);
    }
  }
  return "no such column";
}

class ExploreCommand : public testing::Test {
 protected:
  void SetUp() override {
    const ProcessResult made = work.run({"simulate",
                                         "terrain",
                                         "--output",
                                         "terrain.csv",
                                         "--rows",
                                         "90",
                                         "--columns",
                                         "70",
                                         "--length-scale",
                                         "20",
                                         "--seed",
                                         "4"});
    ASSERT_EQ(0, made.exit_code) << to_string(made);
  }

  Workdir work{TCERT_BINARY};
};

TEST_F(ExploreCommand, WritesSeriesPicturesAndManifest) {
  const std::vector<std::string> arguments{"explore",
                                           "terrain.csv",
                                           "--start",
                                           "45,35",
                                           "--lipschitz",
                                           "18",
                                           "--threshold",
                                           "940",
                                           "--max-steps",
                                           "30",
                                           "--kernel-length-scale",
                                           "20",
                                           "--output",
                                           "run"};
  const ProcessResult run = work.run(arguments);
  ASSERT_EQ(0, run.exit_code) << to_string(run);
  expect_part(run.out, "SYNTHETIC data, seed 4");
  expect_part(run.out, "rules: certified");
  const std::string series = work.read("run/series.csv");
  EXPECT_EQ(0U, series.rfind("step,x,y,measurement,safe_cells,expander_cells,", 0)) << series;
  EXPECT_EQ("0", last_of(series, "unsafe_certified"));
  EXPECT_EQ("0", last_of(series, "unsafe_visits"));
  EXPECT_EQ("4", last_of(series, "synthetic_seed"));
  expect_part(work.read("run/frames/frame_001.svg"), "SYNTHETIC data");
  expect_part(work.read("run/frames/frame_001.svg"), "</svg>");
  const auto manifest = nlohmann::json::parse(work.read("run/manifest.json"));
  EXPECT_EQ("explore", manifest.at("command"));
  // The words of the manifest make the same result.
  std::vector<std::string> words{"explore"};
  for (const auto& word : manifest.at("arguments")) {
    words.push_back(word.is_object() ? word.at("input").get<std::string>()
                                     : word.get<std::string>());
  }
  ASSERT_TRUE(manifest.at("arguments").at(0).is_object());
  EXPECT_EQ("terrain.csv", words.at(1));
  words.insert(words.end(), {"--output", "from_manifest"});
  const ProcessResult made = work.run(words);
  ASSERT_EQ(0, made.exit_code) << to_string(made);
  EXPECT_EQ(series, work.read("from_manifest/series.csv"));
  EXPECT_EQ(work.read("run/manifest.json"), work.read("from_manifest/manifest.json"));
  // One picture is the last.
  words.insert(words.end(), {"--frames", "1"});
  words.at(words.size() - 3) = "one_frame";
  const ProcessResult one = work.run(words);
  ASSERT_EQ(0, one.exit_code) << to_string(one);
  EXPECT_EQ(work.read("run/frames/frame_009.svg"), work.read("one_frame/frames/frame_001.svg"));
  EXPECT_FALSE(std::filesystem::exists(work.path() / "one_frame/frames/frame_002.svg"));
  // The same again gives the same bytes.
  const ProcessResult again = work.run(arguments);
  ASSERT_EQ(0, again.exit_code) << to_string(again);
  EXPECT_EQ(series, work.read("run/series.csv"));
}

TEST_F(ExploreCommand, ReadsThePrintedConfiguration) {
  work.write("config.toml", kPrinted);
  const ProcessResult published = work.run({"explore",
                                            "--config",
                                            "config.toml",
                                            "--rules",
                                            "published",
                                            "--threshold",
                                            "940",
                                            "--start",
                                            "45,35",
                                            "--goal",
                                            "50,40",
                                            "--max-steps",
                                            "20"});
  EXPECT_EQ(0, published.exit_code) << to_string(published);
  expect_part(published.out, "rules: published");
  // The certified rules do not take a constant that the first measurements contradict.
  const ProcessResult certified = work.run({"explore",
                                            "--config",
                                            "config.toml",
                                            "--threshold",
                                            "940",
                                            "--start",
                                            "45,35",
                                            "--goal",
                                            "50,40",
                                            "--max-steps",
                                            "20"});
  EXPECT_EQ(0, certified.exit_code) << to_string(certified);
  expect_part(certified.err, "0.003 is contradicted by the first measurements");
  expect_part(certified.out, "unsafe cells held to be safe, at most: 0");
  work.write("bad.toml", "[optimization]\nLIPSHITZ = 3\n");
  const ProcessResult bad =
      work.run({"explore", "terrain.csv", "--config", "bad.toml", "--start", "45,35"});
  EXPECT_EQ(2, bad.exit_code) << to_string(bad);
  expect_part(bad.err, "did you mean 'optimization.LIPSCHITZ'?");
}

TEST_F(ExploreCommand, SaysWhatIsWrong) {
  const auto refused = [&](std::vector<std::string> arguments, int code, const std::string& part) {
    arguments.insert(arguments.begin(), "explore");
    const ProcessResult run = work.run(arguments);
    EXPECT_EQ(code, run.exit_code) << to_string(run);
    expect_part(run.err, part);
  };
  refused({"nowhere.csv", "--start", "1,1"}, 66, "no such file");
  refused({"terrain.csv"}, 2, "--start");
  refused({"terrain.csv", "--start", "1;1"}, 2, "expected a cell as X,Y");
  refused({"terrain.csv", "--start", "90,1"}, 2, "outside the terrain of 90 x 70 cells");
  refused({"terrain.csv", "--start", "1,1", "--rules", "certfied"}, 2, "did you mean 'certified'?");
  refused({"terrain.csv", "--start", "45,35", "--mode", "navigate"}, 2, "--goal");
  refused({"terrain.csv", "--start", "45,35", "--threshold", "1e6", "--lipschitz", "18"},
          65,
          "is not safe");
  work.write("ragged.csv", "1,2,3\n4,5\n");
  refused({"ragged.csv", "--start", "0,0"}, 65, "ragged.csv:2: error");
  work.write("text.csv", "1,2,3\n4,five,6\n");
  refused({"text.csv", "--start", "0,0"}, 65, "found 'five', expected a finite number");
  work.write("nan.csv", "1,2\n3,nan\n");
  refused({"nan.csv", "--start", "0,0"}, 65, "found 'nan'");
  work.write("row.csv", "1,2,3\n");
  refused({"row.csv", "--start", "0,0"}, 65, "at least two rows");
}

TEST_F(ExploreCommand, EndsWhereTheGoalIsNotReachable) {
  // Two plateaus, a ravine between them.
  std::string text;
  for (int x = 0; x < 30; ++x) {
    for (int y = 0; y < 20; ++y) {
      const int value = x < 12 ? 50 : x < 18 ? -50 : 50;
      text += (y == 0 ? "" : ",") + std::to_string(value);
    }
    text += '\n';
  }
  work.write("ravine.csv", text);
  const ProcessResult run = work.run({"explore",
                                      "ravine.csv",
                                      "--start",
                                      "5,10",
                                      "--goal",
                                      "25,10",
                                      "--threshold",
                                      "0",
                                      "--lipschitz",
                                      "100",
                                      "--kernel-length-scale",
                                      "5",
                                      "--max-steps",
                                      "500"});
  ASSERT_EQ(0, run.exit_code) << to_string(run);
  expect_part(run.out, "the goal (25, 10) is not reachable at this threshold: ");
  expect_part(run.out, "cells are certified, and the frontier stands at (");
  expect_part(run.out, "certificate: NA");
}

}  // namespace
}  // namespace tcert
