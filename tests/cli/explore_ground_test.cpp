// Ground that is reused, rasters and metres of it, bodies on it, and a robot's own loop over it.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <sstream>
#include <string>

#include "datasets/terrain_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/unix_client.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(std::string::npos, text.find(part)) << text << "\nlacks: " << part;
}

/// The first `count` columns of a CSV text.
std::string first_columns(const std::string& csv, int count) {
  std::istringstream lines(csv);
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    std::size_t end = 0;
    for (int k = 0; k < count && end != std::string::npos; ++k) {
      end = line.find(',', k == 0 ? 0 : end + 1);
    }
    text += line.substr(0, end) + '\n';
  }
  return text;
}

double number_after(const std::string& text, const std::string& name) {
  const std::size_t at = text.find(name);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + name.size()));
}

class ExploreGround : public testing::Test {
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
    // Without its label the results have no column for it.
    const std::string text = work.read("terrain.csv");
    work.write("plain.csv", text.substr(text.find('\n') + 1));
  }

  ProcessResult explore(std::vector<std::string> more, const std::string& terrain = "plain.csv") {
    std::vector<std::string> arguments{
        "explore", terrain, "--threshold", "940", "--kernel-length-scale", "20"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return work.run(arguments);
  }

  Workdir work{TCERT_BINARY};
};

TEST_F(ExploreGround, KnownGroundIsNotMeasuredAgain) {
  const ProcessResult first =
      explore({"--start", "45,35", "--goal", "70,50", "--lipschitz", "18", "--output", "first"});
  ASSERT_EQ(0, first.exit_code) << to_string(first);
  const ProcessResult back = explore({"--start",
                                      "70,50",
                                      "--goal",
                                      "45,35",
                                      "--lipschitz",
                                      "18",
                                      "--known",
                                      "first/measurements.csv",
                                      "--start-radius",
                                      "0"});
  ASSERT_EQ(0, back.exit_code) << to_string(back);
  expect_part(back.out, "known, 1 first, 0 after");
  const ProcessResult both =
      explore({"--start", "45,35", "--goal", "70,50;45,35", "--lipschitz", "18"});
  ASSERT_EQ(0, both.exit_code) << to_string(both);
  expect_part(both.out, "goals reached: 2 of 2");
  // Not those of another terrain, nor text.
  work.write("far.csv", "x,y,value\n200,3,1000\n");
  const ProcessResult far =
      explore({"--start", "45,35", "--lipschitz", "18", "--known", "far.csv"});
  EXPECT_EQ(65, far.exit_code) << to_string(far);
  expect_part(far.err, "far.csv:2: error: column 'x': found '200', expected cells of the terrain");
  const ProcessResult none = explore({"--start", "45,35", "--known", "no.csv"});
  EXPECT_EQ(66, none.exit_code) << to_string(none);
}

TEST_F(ExploreGround, AGoalThatCannotBeReachedEndsTheTour) {
  const ProcessResult run =
      explore({"--start", "45,35", "--goal", "70,50;45,35", "--lipschitz", "18", "--body", "12"});
  EXPECT_NE(0, run.exit_code) << to_string(run);
  expect_part(run.out, "goals reached: 0 of 2");
}

TEST_F(ExploreGround, ABodyNeedsMoreGround) {
  const std::vector<std::string> places{"--start", "45,35", "--goal", "70,50", "--lipschitz", "18"};
  const auto with = [&](const std::string& body) {
    std::vector<std::string> all = places;
    all.insert(all.end(), {"--body", body, "--rasters", "csv", "--output", "body"});
    return explore(all);
  };
  const ProcessResult point = explore(places);
  const ProcessResult disc = with("2");
  ASSERT_EQ(0, disc.exit_code) << to_string(disc);
  EXPECT_LT(number_after(disc.out, "certificate: "), number_after(point.out, "certificate: "));
  // The way keeps the body's reach from all that is not certified.
  const auto safe = read_terrain(work.path() / "body/rasters/safe.csv");
  ASSERT_TRUE(safe.terrain) << safe.diagnostics.size();
  std::istringstream path(work.read("body/path.csv"));
  std::string line;
  std::getline(path, line);
  while (std::getline(path, line)) {
    const double x = std::stod(line);
    const double y = std::stod(line.substr(line.find(',') + 1));
    for (int i = 0; i < 90; ++i) {
      for (int j = 0; j < 70; ++j) {
        if (std::hypot(i - x, j - y) < 2.0) {
          EXPECT_EQ(1.0, safe.terrain->values[static_cast<std::size_t>(i * 70 + j)]);
        }
      }
    }
  }
  EXPECT_EQ(0, with("4,2,30").exit_code);
  for (const char* const bad : {"0", "-1", "2,0", "1,2,3,4", "x", "1e9"}) {
    const ProcessResult refused = with(bad);
    EXPECT_EQ(2, refused.exit_code) << to_string(refused);
    expect_part(refused.err, "--body");
  }
}

TEST_F(ExploreGround, TheBandSaysWhatItAssumes) {
  const ProcessResult run = explore({"--start", "45,35", "--goal", "70,50", "--rules", "band"});
  ASSERT_EQ(0, run.exit_code) << to_string(run);
  expect_part(run.out, "assumed: a Gaussian field of length scale 10 cells or more");
  expect_part(run.out, "unsafe cells held to be safe, at most: 0");
  EXPECT_EQ(std::string::npos, run.out.find("Lipschitz"));
  const ProcessResult narrow =
      explore({"--start", "45,35", "--rules", "band", "--beta", "3", "--max-steps", "1"});
  expect_part(narrow.err, "--rules band certifies by a band of 1.73 sd");
}

TEST_F(ExploreGround, RastersReadBackAndKeepTheirSide) {
  const ProcessResult run = explore({"--start",
                                     "45,35",
                                     "--goal",
                                     "70,50",
                                     "--lipschitz",
                                     "18",
                                     "--rasters",
                                     "asc,csv,png",
                                     "--output",
                                     "run"});
  ASSERT_EQ(0, run.exit_code) << to_string(run);
  const auto terrain = read_terrain(work.path() / "plain.csv");
  const auto lower = read_terrain(work.path() / "run/rasters/lower.asc");
  const auto upper = read_terrain(work.path() / "run/rasters/upper.asc");
  const auto safe = read_terrain(work.path() / "run/rasters/safe.asc");
  const auto certificate = read_terrain(work.path() / "run/rasters/certificate.asc");
  ASSERT_TRUE(terrain.terrain && lower.terrain && upper.terrain && safe.terrain &&
              certificate.terrain);
  ASSERT_EQ(90, lower.terrain->rows);
  for (std::size_t i = 0; i < terrain.terrain->values.size(); ++i) {
    const double value = terrain.terrain->values[i];
    EXPECT_LE(lower.terrain->values[i], value);
    EXPECT_GE(upper.terrain->values[i], value);
    if (safe.terrain->values[i] == 1.0) {
      EXPECT_GE(lower.terrain->values[i], 940.0 - 1e-3);
    } else {
      EXPECT_TRUE(std::isnan(certificate.terrain->values[i]));
    }
    if (!std::isnan(certificate.terrain->values[i])) {
      EXPECT_LE(certificate.terrain->values[i], lower.terrain->values[i] - 940.0 + 1e-3);
      EXPECT_GE(certificate.terrain->values[i], -1e-3);
    }
  }
  EXPECT_EQ("\x89PNG", work.read("run/rasters/mean.png").substr(0, 4));
  EXPECT_EQ("\x89PNG", work.read("run/rasters/terrain.png").substr(0, 4));
  const ProcessResult bad = explore({"--start", "45,35", "--rasters", "tif", "--output", "other"});
  EXPECT_EQ(2, bad.exit_code);
  expect_part(bad.err, "expected asc, csv or png");
}

TEST_F(ExploreGround, MetresOfAMapAreCells) {
  // The same terrain as an ESRI grid of half a metre a cell, far from the origin.
  std::string grid = "ncols 70\nnrows 90\nxllcorner 400000\nyllcorner 5000000\ncellsize 0.5\n";
  std::string values = work.read("plain.csv");
  std::replace(values.begin(), values.end(), ',', ' ');
  work.write("map.asc", grid + values);
  const ProcessResult cells = explore({"--start",
                                       "45,35",
                                       "--goal",
                                       "70,50",
                                       "--lipschitz",
                                       "18",
                                       "--body",
                                       "2",
                                       "--output",
                                       "cells"});
  ASSERT_EQ(0, cells.exit_code) << to_string(cells);
  // Cell (45, 35): column 35 from the west, row 45 from the north.
  const ProcessResult metres = work.run({"explore",
                                         "map.asc",
                                         "--threshold",
                                         "940",
                                         "--units",
                                         "metres",
                                         "--kernel-length-scale",
                                         "10",
                                         "--start",
                                         "400017.75,5000022.25",
                                         "--goal",
                                         "400025.25,5000009.75",
                                         "--lipschitz",
                                         "36",
                                         "--body",
                                         "1",
                                         "--output",
                                         "metres",
                                         "--rasters",
                                         "asc,csv"});
  ASSERT_EQ(0, metres.exit_code) << to_string(metres);
  EXPECT_EQ(work.read("cells/series.csv"), work.read("metres/series.csv"));
  expect_part(metres.out, " m\n");
  const std::string safe = work.read("metres/rasters/safe.asc");
  expect_part(safe, "xllcorner 400000\nyllcorner 5000000\ncellsize 0.5\n");
  const auto points = read_terrain(work.path() / "metres/rasters/safe.csv");
  ASSERT_TRUE(points.terrain);
  EXPECT_EQ(400000.25, points.terrain->frame.east);
  EXPECT_EQ(5000000.25, points.terrain->frame.north);
  const ProcessResult off = work.run(
      {"explore", "map.asc", "--threshold", "940", "--units", "metres", "--start", "45,35"});
  EXPECT_EQ(2, off.exit_code);
  expect_part(off.err, "expected a place on the map, from 400000.25,");
  const ProcessResult unknown = explore({"--units", "metres", "--start", "45,35"});
  EXPECT_EQ(2, unknown.exit_code);
  expect_part(unknown.err, "--cell-size M");
}

TEST_F(ExploreGround, BaselinesWalkAndCountTheirFailures) {
  const ProcessResult straight = explore({"--start",
                                          "45,35",
                                          "--goal",
                                          "70,50",
                                          "--baseline",
                                          "straight",
                                          "--output",
                                          "walk",
                                          "--rasters",
                                          "png"});
  ASSERT_EQ(0, straight.exit_code) << to_string(straight);
  expect_part(straight.out, "method: straight");
  expect_part(work.read("walk/frames/frame_001.svg"), "</svg>");
  const ProcessResult sparse =
      explore({"--start", "45,35", "--goal", "70,50", "--baseline", "sparse-rrt", "--seed", "2"});
  expect_part(sparse.out, "measurements: ");
  const ProcessResult none = explore({"--start", "45,35", "--baseline", "straight"});
  EXPECT_EQ(2, none.exit_code);
}

TEST_F(ExploreGround, ARobotIsToldWhatASimulatedOneDoes) {
  for (const std::string rules : {"certified", "band"}) {
    const ProcessResult run = explore({"--start",
                                       "45,35",
                                       "--goal",
                                       "70,50;40,30",
                                       "--rules",
                                       rules,
                                       "--rasters",
                                       "asc",
                                       "--output",
                                       "run_" + rules});
    ASSERT_EQ(0, run.exit_code) << to_string(run);
    const std::string lines = work.read("run_" + rules + "/measurements.csv");
    const ProcessResult live = work.run({"live",        "terrain",      "--rows",
                                         "90",          "--columns",    "70",
                                         "--threshold", "940",          "--kernel-length-scale",
                                         "20",          "--start",      "45,35",
                                         "--goal",      "70,50;40,30",  "--rules",
                                         rules,         "--rasters",    "asc",
                                         "--record",    "live_" + rules},
                                        lines);
    ASSERT_EQ(0, live.exit_code) << to_string(live);
    EXPECT_EQ(first_columns(work.read("run_" + rules + "/series.csv"), 12),
              first_columns(live.out, 12));
    EXPECT_EQ(live.out, work.read("live_" + rules + "/series.csv"));
    for (const char* const file :
         {"path.csv", "measurements.csv", "rasters/lower.asc", "rasters/certificate.asc"}) {
      EXPECT_EQ(work.read("run_" + rules + "/" + file), work.read("live_" + rules + "/" + file))
          << file;
    }
  }
}

/// What is told takes the same band, constant and noise bound in both.
TEST_F(ExploreGround, ARobotIsToldByTheSameOptions) {
  const std::vector<std::vector<std::string>> all{
      {"--trust-model", "--lipschitz", "18"}, {"--lipschitz", "0.5"}, {"--noise-sd", "0.1"}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string name = "same_" + std::to_string(k);
    std::vector<std::string> simulated{
        "--start", "45,35", "--goal", "70,50", "--max-steps", "8", "--output", name};
    simulated.insert(simulated.end(), all[k].begin(), all[k].end());
    const ProcessResult run = explore(simulated);
    std::vector<std::string> told{"live", "terrain", "--rows", "90", "--columns", "70"};
    for (const char* const word : {"--threshold",
                                   "940",
                                   "--kernel-length-scale",
                                   "20",
                                   "--start",
                                   "45,35",
                                   "--goal",
                                   "70,50",
                                   "--max-steps",
                                   "8"}) {
      told.emplace_back(word);
    }
    told.insert(told.end(), all[k].begin(), all[k].end());
    const ProcessResult live = work.run(told, work.read(name + "/measurements.csv"));
    EXPECT_EQ(first_columns(work.read(name + "/series.csv"), 12), first_columns(live.out, 12))
        << to_string(run) << to_string(live);
  }
}

TEST_F(ExploreGround, WhatARobotCannotDoIsRefused) {
  const auto live = [&](std::vector<std::string> more, const std::string& lines) {
    std::vector<std::string> words{"live",
                                   "terrain",
                                   "--rows",
                                   "90",
                                   "--columns",
                                   "70",
                                   "--start",
                                   "45,35",
                                   "--threshold",
                                   "940",
                                   "--lipschitz",
                                   "18"};
    words.insert(words.end(), more.begin(), more.end());
    return work.run(words, lines);
  };
  const ProcessResult jump = live({"--motion", "jump"}, "");
  EXPECT_EQ(2, jump.exit_code);
  expect_part(jump.err, "--motion jump");
  EXPECT_EQ(2, live({"--start-radius", "3"}, "").exit_code);
  const ProcessResult header = live({}, "x,y,value\n45,35,990\na,b,c\n");
  EXPECT_EQ(3, header.exit_code);
  expect_part(header.err, "line 3: a header in the midst of measurements");
  const ProcessResult other = live({}, "45,35,990\n45,35,980\n");
  EXPECT_EQ(3, other.exit_code);
  expect_part(other.err, "differs from the earlier");
  const ProcessResult narrow =
      explore({"--start", "45,35", "--rules", "band", "--least-length-scale", "0.001"});
  EXPECT_NE(70, narrow.exit_code) << to_string(narrow);
}

/// Another process, which knows the terrain and is told where to go over a socket.
TEST_F(ExploreGround, ARobotOverASocketIsToldTheSame) {
  const ProcessResult run =
      explore({"--start", "45,35", "--goal", "70,50", "--lipschitz", "18", "--output", "run"});
  ASSERT_EQ(0, run.exit_code) << to_string(run);
  const auto terrain = read_terrain(work.path() / "plain.csv");
  ASSERT_TRUE(terrain.terrain);
  const std::string path = (work.path() / "robot").string();
  const pid_t child = work.start({"live",        "terrain",     "--rows",
                                  "90",          "--columns",   "70",
                                  "--threshold", "940",         "--kernel-length-scale",
                                  "20",          "--lipschitz", "18",
                                  "--start",     "45,35",       "--goal",
                                  "70,50",       "--listen",    "unix:" + path,
                                  "--record",    "told"});
  const int end = test_support::connected_to(path);
  ASSERT_GE(end, 0);
  const auto send = [&](int x, int y, bool plan) {
    std::ostringstream line;
    line.precision(17);
    line << x << ',' << y << ',' << terrain.terrain->values[static_cast<std::size_t>(x * 70 + y)]
         << ',' << plan << '\n';
    const std::string text = line.str();
    ASSERT_EQ(static_cast<ssize_t>(text.size()), ::write(end, text.data(), text.size()));
  };
  std::string told;
  const auto row = [&] {
    std::string line;
    for (char c = 0; ::read(end, &c, 1) == 1 && c != '\n';) {
      line += c;
    }
    told += line + '\n';
    return line;
  };
  for (int x = 43; x <= 47; ++x) {
    for (int y = 33; y <= 37; ++y) {
      const int d2 = (x - 45) * (x - 45) + (y - 35) * (y - 35);
      if (d2 > 0 && d2 <= 4) {
        send(x, y, false);
      }
    }
  }
  send(45, 35, true);
  row();  // The header.
  for (int step = 0; step < 500; ++step) {
    const std::string line = row();
    const std::size_t last = line.rfind(',');
    if (line.empty() || last + 1 < line.size()) {
      break;  // It ended.
    }
    // The end of the way: its last "x y".
    const std::size_t way = line.rfind(',', last - 1) + 1;
    const std::size_t at = std::min(line.rfind(';', last), last);
    const std::string place = line.substr(at < last && at >= way ? at + 1 : way, last - way);
    int x = 0;
    int y = 0;
    std::istringstream(place) >> x >> y;
    send(x, y, true);
  }
  ::close(end);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_EQ(first_columns(work.read("run/series.csv"), 12), first_columns(told, 12));
  EXPECT_EQ(work.read("run/path.csv"), work.read("told/path.csv"));
  EXPECT_EQ(work.read("run/measurements.csv"), work.read("told/measurements.csv"));
}

TEST_F(ExploreGround, LinesOfARobotThatCannotBeAreSkipped) {
  const std::string lines =
      "# a robot\nx,y,value,plan\n45,34,1000,0\nnonsense,1,2\n45,36,1000,0\n44,35,1000,0\n"
      "{\"x\": 46, \"y\": 35, \"value\": 1000, \"plan\": false}\n500,1,1000,0\n45,35,1000\n"
      "{\"x\": 46, \"y\": 35, \"valu\": 1000}\n45,35.5,1000\n";
  const ProcessResult live = work.run({"live",
                                       "terrain",
                                       "--rows",
                                       "90",
                                       "--columns",
                                       "70",
                                       "--threshold",
                                       "940",
                                       "--lipschitz",
                                       "18",
                                       "--start",
                                       "45,35"},
                                      lines);
  EXPECT_EQ(3, live.exit_code) << to_string(live);
  expect_part(live.err, "line 4: found 'nonsense,1,2', expected x,y,value");
  expect_part(live.err, "line 8: the cell (500, 1) lies outside the terrain of 90 x 70 cells");
  expect_part(live.err, "line 11: found '45,35.5,1000'");
  expect_part(live.out, "\n0,45,35,1000,");
  const ProcessResult thesis = work.run(
      {"live", "terrain", "--rows", "9", "--columns", "9", "--start", "1,1", "--rules", "thesis"});
  EXPECT_EQ(2, thesis.exit_code);
  const ProcessResult nothing = work.run({"live", "terrain", "--start", "1,1"});
  EXPECT_EQ(2, nothing.exit_code);
  expect_part(nothing.err, "needs LAYOUT");
}

}  // namespace
}  // namespace tcert
