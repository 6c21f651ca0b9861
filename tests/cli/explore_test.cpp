#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "cli/ground_runs.hpp"
#include "support/expect_part.hpp"

namespace tcert {
namespace {

using test_support::expect_part;
using test_support::ProcessResult;
using test_support::to_string;

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

class ExploreCommand : public test_support::GroundRuns {};

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
  ASSERT_EQ(7, run.exit_code) << to_string(run);
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
  ASSERT_EQ(7, made.exit_code) << to_string(made);
  EXPECT_EQ(series, work.read("from_manifest/series.csv"));
  EXPECT_EQ(work.read("run/manifest.json"), work.read("from_manifest/manifest.json"));
  // One picture is the last.
  words.insert(words.end(), {"--frames", "1"});
  words.at(words.size() - 3) = "one_frame";
  const ProcessResult one = work.run(words);
  ASSERT_EQ(7, one.exit_code) << to_string(one);
  EXPECT_EQ(work.read("run/frames/frame_009.svg"), work.read("one_frame/frames/frame_001.svg"));
  EXPECT_FALSE(std::filesystem::exists(work.path() / "one_frame/frames/frame_002.svg"));
  // The same again gives the same bytes.
  const ProcessResult again = work.run(arguments);
  ASSERT_EQ(7, again.exit_code) << to_string(again);
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
  // What is estimated instead is too wide for a goal within 20 steps.
  EXPECT_EQ(7, certified.exit_code) << to_string(certified);
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
  refused({"terrain.csv", "--start", "45,35", "--threshold", "nan"}, 2, "found nan, expected");
  refused({"terrain.csv",
           "--start",
           "45,35",
           "--threshold",
           "940",
           "--lipschitz",
           "18",
           "--noise-bound",
           "1e6"},
          65,
          "less --noise-bound 1000000");
  work.write("ragged.csv", "1,2,3\n4,5\n");
  refused({"ragged.csv", "--start", "0,0"}, 65, "ragged.csv:2: error");
  work.write("text.csv", "1,2,3\n4,five,6\n");
  refused({"text.csv", "--start", "0,0"}, 65, "found 'five', expected a finite number");
  work.write("nan.csv", "1,2\n3,nan\n");
  refused({"nan.csv", "--start", "1,1"}, 65, "the start (1, 1) lies in a gap of the terrain");
  refused({"nan.csv", "--start", "0,0", "--goal", "1,1"}, 65, "the goal (1, 1) lies in a gap");
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
  ASSERT_EQ(4, run.exit_code) << to_string(run);
  expect_part(run.out, "end: not reachable at this threshold\n");
  expect_part(run.out, "the goal (25, 10) is not reachable at this threshold: ");
  expect_part(run.out, "cells are certified, and the frontier stands at (");
  expect_part(run.out, "certificate: NA (start and goal are not joined over certified ground)");
}

/// `rows` x `columns` cells of `value`, but those of row `of` are `other`.
std::string plateau(
    int rows, int columns, const std::string& value, int of = -1, const std::string& other = {}) {
  std::string text;
  for (int x = 0; x < rows; ++x) {
    for (int y = 0; y < columns; ++y) {
      text += (y == 0 ? "" : ",") + (x == of && y > 0 && y + 1 < columns ? other : value);
    }
    text += '\n';
  }
  return text;
}

TEST_F(ExploreCommand, NamesEveryEndByWordAndExitCode) {
  work.write("flat.csv", plateau(12, 12, "100"));
  work.write("low.csv", plateau(12, 12, "1"));
  work.write("wall.csv", plateau(12, 12, "0", 6, "1"));
  std::string whole;
  for (int x = 0; x < 12; ++x) {
    whole += x == 6 ? "1,1,1,1,1,1,1,1,1,1,1,1\n" : "0,0,0,0,0,0,0,0,0,0,0,0\n";
  }
  work.write("cut.csv", whole);
  const auto ends = [&](std::vector<std::string> more, int code, const std::string& part) {
    std::vector<std::string> arguments{"explore", "flat.csv", "--start", "2,2", "--threshold", "5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult run = work.run(arguments);
    EXPECT_EQ(code, run.exit_code) << to_string(run);
    expect_part(run.out + run.err, part);
  };
  ends({"--lipschitz", "20", "--goal", "9,9"}, 0, "end: reached");
  ends({"--lipschitz", "1"}, 0, "end: explored: no cell can make the ground grow");
  ends({"--lipschitz", "200", "--goal", "9,9"}, 5, "only the Lipschitz constant forbids it");
  ends({"--lipschitz", "80", "--goal", "9,9", "--max-steps", "1"}, 7, "end: step limit");
  const ProcessResult nothing = work.run(
      {"explore", "low.csv", "--start", "2,2", "--threshold", "5", "--rules", "published"});
  EXPECT_EQ(8, nothing.exit_code) << to_string(nothing);
  expect_part(nothing.out, "end: empty safe set");
  ends({"--lipschitz", "200", "--goal", "9,9", "--rules", "thesis"},
       5,
       "only the rule set forbids it");
  ends({"--lipschitz", "20", "--goal", "6,2", "--obstacles", "wall.csv"},
       65,
       "the goal (6, 2) lies in a physical obstacle");
  ends({"--lipschitz", "20", "--goal", "9,9", "--obstacles", "cut.csv"},
       65,
       "the goal (9, 9) cannot be reached whatever the ground is");
  // A ramp, whose corner is certified after some steps only.
  std::string ramp;
  for (int x = 0; x < 60; ++x) {
    for (int y = 0; y < 50; ++y) {
      ramp += (y == 0 ? "" : ",") + std::to_string(x);
    }
    ramp += '\n';
  }
  work.write("ramp.csv", ramp);
  const ProcessResult edge = work.run({"explore",
                                       "ramp.csv",
                                       "--start",
                                       "45,4",
                                       "--goal",
                                       "59,49",
                                       "--threshold",
                                       "30",
                                       "--rules",
                                       "published",
                                       "--max-steps",
                                       "30"});
  EXPECT_EQ(6, edge.exit_code) << to_string(edge);
  expect_part(
      edge.out,
      "is certified and joined, but less than 4 cells (--simplification) within the outline");
  const ProcessResult help = work.run({"explore", "--help"});
  for (const char* const part :
       {"4 not reachable", "5 only the", "6 the goal", "7 the limit", "8 stranded"}) {
    expect_part(help.out, part);
  }
}

TEST_F(ExploreCommand, FlagsThatTheRulesWouldNotLookAtAreErrors) {
  const auto refused =
      [&](const std::string& rules, std::vector<std::string> flags, const std::string& part) {
        std::vector<std::string> arguments{
            "explore", "terrain.csv", "--start", "45,35", "--threshold", "940", "--rules", rules};
        arguments.insert(arguments.end(), flags.begin(), flags.end());
        const ProcessResult run = work.run(arguments);
        EXPECT_EQ(2, run.exit_code) << to_string(run);
        expect_part(run.err, part);
        expect_part(run.err, flags.front());
      };
  for (const std::string rules : {"thesis", "published"}) {
    for (const std::vector<std::string>& flags : {std::vector<std::string>{"--look-ahead"},
                                                  {"--trust-model"},
                                                  {"--noise-bound", "1"},
                                                  {"--confidence", "0.9"}}) {
      refused(rules, flags, "--rules " + rules);
    }
  }
  refused("published", {"--start-radius", "1"}, "--rules published");
  refused("thesis", {"--simplification", "3"}, "--rules thesis");
  refused("certified", {"--travel-weight", "0.5", "--selection", "thesis"}, "--selection thesis");
  refused("certified", {"--horizon", "4", "--look-ahead"}, "--selection horizon");
  refused("certified", {"--growth-weight", "0.5"}, "--selection pareto");
  refused("certified", {"--sub-goal-depth", "6"}, "--motion reactive");
  refused("certified", {"--gradient-prior", "3,20", "--lipschitz", "18"}, "--lipschitz");
  refused("certified", {"--least-length-scale", "5"}, "--rules band");
  refused("band", {"--lipschitz", "18"}, "--rules certified or thesis or published");
  refused("band", {"--noise-bound", "1"}, "--rules certified");
  refused("certified", {"--goal", "50,40", "--mode", "explore"}, "--mode explore");
  refused("thesis", {"--lipschitz", "auto"}, "only --rules certified estimates it");
  refused("certified",
          {"--lipschitz", "1e300"},
          "expected a number above 0, from 1e-30 to 1e+30, or auto");
  // It acts on the published expanders, not on the safe set: no error, but a word.
  const ProcessResult partly = work.run({"explore",
                                         "terrain.csv",
                                         "--start",
                                         "45,35",
                                         "--threshold",
                                         "940",
                                         "--rules",
                                         "published",
                                         "--lipschitz",
                                         "18",
                                         "--max-steps",
                                         "2"});
  EXPECT_EQ(0, partly.exit_code) << to_string(partly);
  expect_part(partly.err, "--lipschitz acts on the expanders alone");
  expect_part(partly.out, "Lipschitz constant: 18\n");
  const ProcessResult note = work.run({"explore",
                                       "terrain.csv",
                                       "--start",
                                       "45,35",
                                       "--threshold",
                                       "940",
                                       "--lipschitz",
                                       "18",
                                       "--robot-radius",
                                       "3",
                                       "--max-steps",
                                       "2"});
  expect_part(note.err, "note: --robot-radius keeps the robot's body off the borders");
}

TEST_F(ExploreCommand, WarnsOfTheThesisConstantAndOfANarrowTrustedBand) {
  const auto err = [&](std::vector<std::string> more) {
    std::vector<std::string> arguments{
        "explore", "terrain.csv", "--start", "45,35", "--threshold", "940", "--max-steps", "2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return work.run(arguments).err;
  };
  expect_part(err({"--rules", "thesis"}),
              "the Lipschitz constant 0.003 is contradicted by the first measurements");
  EXPECT_EQ("", err({"--rules", "thesis", "--lipschitz", "18"}));
  expect_part(err({"--lipschitz", "18", "--trust-model", "--beta", "3"}),
              "a band of 1.73 sd (--beta 3)");
  EXPECT_EQ("", err({"--lipschitz", "18", "--trust-model"})) << "5 sd by default";
}

TEST_F(ExploreCommand, TakesStartGoalAndFramesFromTheConfiguration) {
  const std::string head = R"([environment]
FILENAME = "terrain.csv"
THRESHOLD = 940
MODE = "semnav"
[robot]
)";
  const std::string places = "STARTING_X = 45\nSTARTING_Y = 35\nGOAL_X = 50\nGOAL_Y = 40\n";
  work.write("config.toml",
             head + "MODE = \"navigate\"\n" + places +
                 "[optimization]\nLIPSCHITZ = 18\n[display]\nFRAMECOUNT = 2");
  const ProcessResult run = work.run({"explore", "--config", "config.toml", "--output", "out"});
  EXPECT_EQ(0, run.exit_code) << to_string(run);
  expect_part(run.err, "environment.MODE = semnav has no effect here");
  expect_part(run.out, "end: reached");
  EXPECT_TRUE(std::filesystem::exists(work.path() / "out/frames/frame_001.svg"));
  EXPECT_FALSE(std::filesystem::exists(work.path() / "out/frames/frame_003.svg"));
  const std::string path = work.read("out/path.csv");
  expect_part(path, "\n45,35,");
  // Flags go first.
  const ProcessResult flag =
      work.run({"explore", "--config", "config.toml", "--start", "46,36", "--output", "other"});
  EXPECT_EQ(0, flag.exit_code) << to_string(flag);
  EXPECT_EQ(std::string::npos, work.read("other/path.csv").find("\n45,35,"));
  const auto refused = [&](const std::string& text, const std::string& part) {
    work.write("bad.toml", text);
    const ProcessResult bad = work.run({"explore", "--config", "bad.toml"});
    EXPECT_EQ(2, bad.exit_code) << to_string(bad);
    expect_part(bad.err, part);
  };
  refused(head + "STARTING_X = 45\n", "expected both of robot.STARTING_X and robot.STARTING_Y");
  refused(head + "STARTING_X = 4.5\nSTARTING_Y = 1\n", "expected a whole number from 0 to 8191");
  refused(head + "MODE = \"semnav\"\n" + places, "robot.MODE: found 'semnav'");
  refused(head + places + "[display]\nFRAMECOUNT = 1e300\n", "display.FRAMECOUNT: found '1e300'");
  refused(head + places + "[optimization]\nNUM_EXPANDERS = 1e300\n", "optimization.NUM_EXPANDERS");
}

TEST_F(ExploreCommand, GoesRoundGapsOfAllKinds) {
  for (const std::string gap : {"3.4028235e38", "-9999", "-32768", "nan", "", "1e300"}) {
    work.write("gaps.csv", plateau(20, 15, "1200.5", 9, gap));
    const ProcessResult run = work.run({"explore",
                                        "gaps.csv",
                                        "--start",
                                        "4,7",
                                        "--goal",
                                        "15,7",
                                        "--threshold",
                                        "1000",
                                        "--lipschitz",
                                        "25",
                                        "--output",
                                        "run"});
    ASSERT_EQ(0, run.exit_code) << to_string(run);
    expect_part(run.err, "13 of 300 cells are gaps");
    EXPECT_EQ(std::string::npos, run.out.find("NA")) << run.out;
    expect_part(run.out, "Lipschitz constant: 25");
    EXPECT_EQ(std::string::npos, work.read("run/path.csv").find("\n9,7,")) << gap;
  }
  work.write("gaps.csv", plateau(20, 15, "1200.5", 9, "-77"));
  const ProcessResult told = work.run({"explore",
                                       "gaps.csv",
                                       "--start",
                                       "4,7",
                                       "--threshold",
                                       "1000",
                                       "--lipschitz",
                                       "25",
                                       "--nodata",
                                       "-77"});
  expect_part(told.err, "13 of 300 cells are gaps (13 of the nodata value -77)");
}

TEST_F(ExploreCommand, ANodataValueOfTheTerrainIsNoneOfTheObstacles) {
  work.write("terrain.csv", plateau(20, 15, "1200.5", 9, "0"));
  work.write("obstacles.csv", plateau(20, 15, "0", 12, "1"));
  const ProcessResult run = work.run({"explore",
                                      "terrain.csv",
                                      "--start",
                                      "4,7",
                                      "--goal",
                                      "15,7",
                                      "--threshold",
                                      "1000",
                                      "--lipschitz",
                                      "25",
                                      "--nodata",
                                      "0",
                                      "--obstacles",
                                      "obstacles.csv"});
  EXPECT_EQ(0, run.exit_code) << to_string(run);
  expect_part(run.err, "13 of 300 cells are gaps (13 of the nodata value 0)");
  // How a terrain is read belongs to what is made again.
  const ProcessResult kept = work.run({"explore",
                                       "terrain.csv",
                                       "--start",
                                       "4,7",
                                       "--threshold",
                                       "1000",
                                       "--lipschitz",
                                       "25",
                                       "--nodata",
                                       "-1",
                                       "--terrain-format",
                                       "grid",
                                       "--obstacles",
                                       "obstacles.csv",
                                       "--output",
                                       "kept"});
  EXPECT_EQ(0, kept.exit_code) << to_string(kept);
  const ProcessResult stands = work.run({"verify", "kept", "--inputs", "."});
  EXPECT_EQ(0, stands.exit_code) << to_string(stands);
}

TEST_F(ExploreCommand, ReadsPointsAndEsriGridsAndRefusesImages) {
  std::string points = "x,y,z\n";
  std::string esri = "ncols 12\nnrows 20\nxllcorner 500000\nyllcorner 4000000\ncellsize 0.5\n";
  for (int x = 0; x < 20; ++x) {
    for (int y = 0; y < 12; ++y) {
      points += std::to_string(500000 + x) + ',' + std::to_string(4000000 + y) + ",100\n";
      esri += "100 ";
    }
    esri += '\n';
  }
  work.write("points.xyz", points);
  work.write("dem.asc", esri);
  work.write("in.tif", std::string("II*\0\x08\0\0\0\x9b\xff", 10));
  const auto run = [&](const std::string& file) {
    return work.run({"explore",
                     file,
                     "--start",
                     "2,2",
                     "--goal",
                     "17,9",
                     "--threshold",
                     "5",
                     "--lipschitz",
                     "20"});
  };
  for (const std::string file : {"points.xyz", "dem.asc"}) {
    const ProcessResult result = run(file);
    EXPECT_EQ(0, result.exit_code) << to_string(result);
    expect_part(result.err, "20 x 12 cells");
  }
  const ProcessResult image = run("in.tif");
  EXPECT_EQ(65, image.exit_code);
  expect_part(image.err, "gdal_translate -of AAIGrid in.tif out.asc");
  EXPECT_EQ(std::string::npos, image.err.find('\x9b'));
}

TEST_F(ExploreCommand, DrawsPseudoObstaclesOverTheFreeSpace) {
  const ProcessResult run = work.run({"explore",
                                      "terrain.csv",
                                      "--start",
                                      "45,35",
                                      "--lipschitz",
                                      "18",
                                      "--threshold",
                                      "940",
                                      "--motion",
                                      "reactive",
                                      "--kernel-length-scale",
                                      "20",
                                      "--max-steps",
                                      "12",
                                      "--output",
                                      "run"});
  expect_part(run.out, "ways on which the controller arrived: ");
  std::size_t seen = 0;
  for (const std::string& name : work.files("run/frames")) {
    const std::string svg = work.read("run/frames/" + name);
    const std::size_t green = svg.find("#30b050");
    if (green != std::string::npos) {
      ++seen;
      EXPECT_LT(green, svg.find("fill=\"#000000\"")) << name;
    }
  }
  EXPECT_GT(seen, 0U);
}

}  // namespace
}  // namespace tcert
