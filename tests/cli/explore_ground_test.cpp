// Ground that is reused, rasters and metres of it, bodies on it, and a robot's own loop over it.
#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <sstream>
#include <string>

#include "cli/ground_runs.hpp"
#include "datasets/terrain_file.hpp"
#include "support/expect_part.hpp"
#include "support/unix_client.hpp"

namespace tcert {
namespace {

using test_support::expect_part;
using test_support::ProcessResult;
using test_support::to_string;

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

class ExploreGround : public test_support::GroundRuns {};

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

TEST_F(ExploreGround, SaysWhatHoldsARobotThatCannotSetOut) {
  const ProcessResult body =
      explore({"--start", "45,35", "--lipschitz", "300", "--start-radius", "1", "--body", "3"});
  EXPECT_EQ(8, body.exit_code) << to_string(body);
  expect_part(
      body.out,
      "the start (45, 35) has ground under the body that is not certified, or the map's edge");
  expect_part(body.out, "--start-radius measures more round the start");
  const ProcessResult bounded =
      explore({"--start", "45,35", "--goal", "70,50", "--gradient-prior", "200,100"});
  EXPECT_EQ(5, bounded.exit_code) << to_string(bounded);
  expect_part(bounded.out, "this L was bounded from the measurements: give the terrain's own");
  const auto err = [&](const char* threshold) {
    return work
        .run({"explore",
              "terrain.csv",
              "--start",
              "45,35",
              "--lipschitz",
              "18",
              "--threshold",
              threshold,
              "--max-steps",
              "0"})
        .err;
  };
  expect_part(err("1e6"), "terrain.csv: no cell is safe: the values run from ");
  expect_part(err("-1e6"), "terrain.csv: every cell is safe: the values run from ");
  EXPECT_EQ("", err("940"));
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
  const auto terrain = read_terrain(work.path() / "terrain.csv");
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
  std::string values = work.read("terrain.csv");
  values.erase(0, values.find('\n') + 1);  // The label, for which an ESRI grid has no place.
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
  EXPECT_EQ(first_columns(work.read("cells/series.csv"), 14), work.read("metres/series.csv"));
  expect_part(metres.out, " m\n");
  EXPECT_EQ(0U, work.read("metres/path.csv").find("x,y,map_x,map_y\n45,35,400017.75,5000022.25\n"));
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
    const std::vector<std::string> about{
        "--start", "45,35", "--goal", "70,50;40,30", "--rules", rules, "--rasters", "asc"};
    const auto with = [&](const char* option, const std::string& folder) {
      std::vector<std::string> words = about;
      words.insert(words.end(), {option, folder});
      return words;
    };
    const ProcessResult run = explore(with("--output", "run_" + rules));
    ASSERT_EQ(0, run.exit_code) << to_string(run);
    const ProcessResult told =
        live(with("--record", "live_" + rules), work.read("run_" + rules + "/measurements.csv"));
    ASSERT_EQ(0, told.exit_code) << to_string(told);
    EXPECT_EQ(first_columns(work.read("run_" + rules + "/series.csv"), 12),
              first_columns(told.out, 12));
    EXPECT_EQ(told.out, work.read("live_" + rules + "/series.csv"));
    expect_part(told.out, ",end,synthetic_seed\n");
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
    std::vector<std::string> words = all[k];
    words.insert(words.end(), {"--start", "45,35", "--goal", "70,50", "--max-steps", "8"});
    std::vector<std::string> simulated = words;
    simulated.insert(simulated.end(), {"--output", name});
    const ProcessResult run = explore(simulated);
    const ProcessResult told = live(words, work.read(name + "/measurements.csv"));
    EXPECT_EQ(first_columns(work.read(name + "/series.csv"), 12), first_columns(told.out, 12))
        << to_string(run) << to_string(told);
  }
}

TEST_F(ExploreGround, WhatARobotCannotDoIsRefused) {
  const auto with = [&](std::vector<std::string> more, const std::string& lines) {
    more.insert(more.end(), {"--start", "45,35", "--lipschitz", "18"});
    return live(more, lines);
  };
  const ProcessResult jump = with({"--motion", "jump"}, "");
  EXPECT_EQ(2, jump.exit_code);
  expect_part(jump.err, "--motion jump");
  EXPECT_EQ(2, with({"--start-radius", "3"}, "").exit_code);
  const ProcessResult header = with({}, "x,y,value\n45,35,990\na,b,c\n");
  EXPECT_EQ(3, header.exit_code);
  expect_part(header.err, "line 3: a header in the midst of measurements");
  const ProcessResult other = with({}, "45,35,990\n45,35,980\n");
  EXPECT_EQ(3, other.exit_code);
  expect_part(other.err, "differs from the earlier");
  const ProcessResult narrow =
      explore({"--start", "45,35", "--rules", "band", "--least-length-scale", "0.001"});
  EXPECT_NE(70, narrow.exit_code) << to_string(narrow);
}

/// A robot that knows the terrain and is told where to go over a socket, by another process.
class Robot {
 public:
  Robot(const std::string& path, TerrainGrid terrain)
      : end_(test_support::connected_to(path)), terrain_(std::move(terrain)) {
    send("x,y,value,plan,synthetic_seed\n");
  }
  ~Robot() { ::close(end_); }
  Robot(const Robot&) = delete;
  Robot& operator=(const Robot&) = delete;

  void send(const std::string& text) const {
    ASSERT_EQ(static_cast<ssize_t>(text.size()), ::write(end_, text.data(), text.size()));
  }

  void measure(int x, int y, bool plan) const {
    std::ostringstream line;
    line.precision(17);
    line << x << ',' << y << ','
         << terrain_.values[static_cast<std::size_t>(x * terrain_.columns + y)] << ',' << plan
         << ",4\n";
    send(line.str());
  }

  std::string line() const {
    std::string text;
    for (char c = 0; ::read(end_, &c, 1) == 1 && c != '\n';) {
      text += c;
    }
    return text;
  }

  /// Where the robot stands it has measured all round; then it goes where it is told. What it was
  /// told.
  std::string explore(int x, int y) const {
    for (int i = x - 2; i <= x + 2; ++i) {
      for (int j = y - 2; j <= y + 2; ++j) {
        const int d2 = (i - x) * (i - x) + (j - y) * (j - y);
        if (d2 > 0 && d2 <= 4) {
          measure(i, j, false);
        }
      }
    }
    measure(x, y, true);
    const std::string header = line();
    std::string told = header + '\n';
    for (int step = 0; step < 500; ++step) {
      const std::string row = line();
      told += row + '\n';
      std::istringstream way(cell_of(header, row, "way"));
      if (row.empty() || !cell_of(header, row, "end").empty()) {
        break;
      }
      for (std::string place; std::getline(way, place, ';');) {
        std::istringstream(place) >> x >> y;
      }
      measure(x, y, true);
    }
    return told;
  }

 private:
  static std::string cell_of(const std::string& header,
                             const std::string& row,
                             const std::string& name) {
    std::istringstream names(header);
    std::istringstream cells(row);
    std::string cell;
    for (std::string one; std::getline(names, one, ',') && one != name;) {
      std::getline(cells, cell, ',');
    }
    std::getline(cells, cell, ',');
    return cell;
  }

  int end_;
  TerrainGrid terrain_;
};

TEST_F(ExploreGround, ARobotOverASocketIsToldTheSame) {
  const auto terrain = read_terrain(work.path() / "terrain.csv");
  ASSERT_TRUE(terrain.terrain);
  const std::vector<std::vector<std::string>> all{
      {"--lipschitz", "18"}, {"--lipschitz", "auto"}, {"--rules", "band"}, {"--body", "1.5"}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string number = std::to_string(k);
    std::vector<std::string> words = all[k];
    words.insert(words.end(), {"--start", "45,35", "--goal", "70,50", "--rasters", "asc,csv"});
    std::vector<std::string> simulated = words;
    simulated.insert(simulated.end(), {"--output", "run" + number});
    const ProcessResult run = explore(simulated);
    const std::string path = (work.path() / ("robot" + number)).string();
    words.insert(words.begin(), {"live", "terrain", "--rows", "90", "--columns", "70"});
    words.insert(words.end(), {"--listen", "unix:" + path, "--record", "told" + number});
    const pid_t child = work.start(about_ground(words));
    const std::string told = Robot(path, *terrain.terrain).explore(45, 35);
    int status = 0;
    ::waitpid(child, &status, 0);
    // What only the terrain can tell apart has another code.
    EXPECT_TRUE(WIFEXITED(status) && (WEXITSTATUS(status) == run.exit_code || run.exit_code == 4))
        << status << to_string(run);
    EXPECT_EQ(first_columns(work.read("run" + number + "/series.csv"), 12),
              first_columns(told, 12));
    EXPECT_EQ(told, work.read("told" + number + "/series.csv"));
    std::vector<std::string> files = work.files("run" + number + "/rasters");
    EXPECT_LE(12U, files.size());
    for (std::string& file : files) {
      file.insert(0, "rasters/");
    }
    files.insert(files.end(), {"path.csv", "measurements.csv"});
    for (const std::string& file : files) {
      EXPECT_EQ(work.read("run" + number + "/" + file), work.read("told" + number + "/" + file))
          << file;
    }
  }
}

/// It does not wait for an answer for ever.
TEST_F(ExploreGround, ARobotOverASocketIsToldWhyThereIsNoRow) {
  const std::string path = (work.path() / "robot").string();
  const pid_t child = work.start(about_ground({"live",
                                               "terrain",
                                               "--rows",
                                               "90",
                                               "--columns",
                                               "70",
                                               "--start",
                                               "45,35",
                                               "--lipschitz",
                                               "18",
                                               "--listen",
                                               "unix:" + path}));
  {
    const Robot robot(path, {});
    robot.send("45,200,1000,1,4\n");
    expect_part(robot.line(), "# line 2: the cell (45, 200) lies outside the terrain of 90 x 70");
    robot.send("45,35,900,1,4\n");
    expect_part(robot.line(), "# line 3: the start is not safe: 900");
    // It may measure more, and ask again; soft ground beside it is no harm.
    robot.send("44,35,930,0,4\n45,35,945,1,4\n");
    expect_part(robot.line(), "step,x,y,");
    expect_part(robot.line(), "0,45,35,945,1,");
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 3) << status;
}

TEST_F(ExploreGround, LinesOfARobotThatCannotBeAreSkipped) {
  const std::string lines =
      "# a robot\nx,y,value,plan\n45,34,1000,0\nnonsense,1,2\n45,36,1000,0\n44,35,1000,0\n"
      "{\"x\": 46, \"y\": 35, \"value\": 1000, \"plan\": false}\n500,1,1000,0\n45,35,1000,1\n"
      "{\"x\": 46, \"y\": 35, \"valu\": 1000}\n45,35.5,1000,1\n";
  const ProcessResult told = live({"--start", "45,35", "--lipschitz", "18"}, lines);
  EXPECT_EQ(3, told.exit_code) << to_string(told);
  expect_part(told.err, "line 4: found 'nonsense,1,2', expected x,y,value");
  expect_part(told.err, "line 8: the cell (500, 1) lies outside the terrain of 90 x 70 cells");
  expect_part(told.err, "line 11: found '45,35.5,1000,1'");
  expect_part(told.out, "\n0,45,35,1000,");
  EXPECT_EQ(2, live({"--start", "1,1", "--rules", "thesis"}, "").exit_code);
  const ProcessResult nothing = work.run({"live", "terrain", "--start", "1,1"});
  EXPECT_EQ(2, nothing.exit_code);
  expect_part(nothing.err, "needs LAYOUT");
}

}  // namespace
}  // namespace tcert
