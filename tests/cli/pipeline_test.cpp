#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <table/csv.hpp>
#include <thread>
#include <utility>

#include "support/temporary_folder.hpp"
#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_done(const ProcessResult& run) { ASSERT_EQ(run.exit_code, 0) << to_string(run); }

void expect_same_folders(const Workdir& work, const std::string& a, const std::string& b) {
  const auto files = work.files(a);
  EXPECT_FALSE(files.empty());
  ASSERT_EQ(files, work.files(b));
  for (const std::string& file : files) {
    EXPECT_TRUE(work.read(a + "/" + file) == work.read(b + "/" + file)) << file << " differs";
  }
}

TEST(Pipeline, ThreadsDoNotChangeAByte) {
  Workdir work(TCERT_BINARY);
  for (const std::string threads : {"1", "2"}) {
    const std::string corpus = "corpus" + threads;
    expect_done(work.run({"simulate", "--trials", "80", "--threads", threads, "--output", corpus}));
    expect_done(
        work.run({"certify", "corpus1", "--threads", threads, "--output", "out" + threads}));
  }
  expect_same_folders(work, "corpus1", "corpus2");
  expect_same_folders(work, "out1", "out2");
}

TEST(Pipeline, ATrialDependsOnSeedAndIndexAlone) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "20", "--output", "few"}));
  expect_done(work.run({"simulate", "--trials", "30", "--output", "more"}));
  EXPECT_EQ(work.read("few/logs/t0000019/pose.csv"), work.read("more/logs/t0000019/pose.csv"));
  EXPECT_NE(work.read("few/logs/t0000018/pose.csv"), work.read("few/logs/t0000019/pose.csv"));
}

TEST(Pipeline, LiveWritesTheRowsOfCertify) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "50", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--ticks", "--output", "out"}));
  int trials = 0;
  for (const std::string& file : work.files("out/ticks")) {
    const ProcessResult live =
        work.run({"live", "--bundle", "corpus"}, work.read("out/ticks/" + file));
    expect_done(live);
    EXPECT_TRUE(live.out == work.read("out/series/" + file)) << file;
    ++trials;
  }
  EXPECT_EQ(trials, 50);
}

TEST(Pipeline, LiveSurvivesLinesThatAreNoTicks) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "1", "--output", "corpus"}));
  expect_done(work.run({"certify", "corpus", "--ticks", "--output", "out"}));
  std::istringstream ticks(work.read("out/ticks/t0000000.csv"));
  std::string with_rubbish;
  std::size_t line_number = 0;
  for (std::string line; std::getline(ticks, line); ++line_number) {
    with_rubbish += line + "\n" + (line_number == 100 ? "1.5,rubbish\n" : "");
  }
  const ProcessResult live = work.run({"live", "--bundle", "corpus"}, with_rubbish);
  EXPECT_EQ(live.exit_code, 3) << live.err;
  EXPECT_NE(live.err.find(":102:"), std::string::npos) << live.err;
  EXPECT_TRUE(live.out == work.read("out/series/t0000000.csv"));
}

TEST(Pipeline, ARejectedTrialIsNamedAndTheRestGoesOn) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "5", "--output", "corpus"}));
  work.write("corpus/logs/t0000002/pose.csv", "time_s,x_m,y_m,yaw_rad\n0,0,abc,0\n");
  const ProcessResult run = work.run({"certify", "corpus", "--output", "out"});
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  EXPECT_NE(run.err.find("t0000002"), std::string::npos) << run.err;
  EXPECT_EQ(work.files("out/series").size(), 4U);
  EXPECT_NE(work.read("out/diagnostics.csv").find("abc"), std::string::npos);
  const ProcessResult strict = work.run({"certify", "corpus", "--strict", "--output", "strict"});
  EXPECT_EQ(strict.exit_code, 65) << to_string(strict);
  EXPECT_FALSE(std::filesystem::exists(work / "strict"));
}

TEST(Pipeline, CheckEndsWithOneWhereSomethingIsWrong) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "3", "--output", "corpus"}));
  expect_done(work.run({"check", "corpus"}));
  work.write("run.csv", "time_s,a\n0,1\n0,2\n");
  const ProcessResult run = work.run({"check", "run.csv", "--format", "json"});
  EXPECT_EQ(run.exit_code, 1) << to_string(run);
  EXPECT_TRUE(nlohmann::json::accept(run.out)) << run.out;
}

// A tip whose force sensor hangs, beside two healthy ones.
TEST(Pipeline, CheckNamesAContactThatNeverEnds) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "2", "--output", "corpus"}));
  std::istringstream log(work.read("corpus/logs/t0000001/tactile.csv"));
  std::string spoilt;
  bool is_header = true;
  for (std::string line; std::getline(log, line); spoilt += line + '\n') {
    if (line.empty() || line[0] == '#' || std::exchange(is_header, false)) {
      continue;  // time_s,left_bend_rad,left_fsr_n,...
    }
    const std::size_t second = line.find(',', line.find(',') + 1) + 1;
    line.replace(second, line.find(',', second) - second, "0.8");
  }
  work.write("corpus/logs/t0000001/tactile.csv", spoilt);
  const ProcessResult run = work.run({"check", "corpus"});
  EXPECT_EQ(run.exit_code, 1) << to_string(run);
  EXPECT_NE(run.out.find("contact from 0.0 s to the end at"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("left_fsr_n"), std::string::npos) << run.out;
  EXPECT_EQ(run.out.find("right_fsr_n"), std::string::npos) << run.out;
  EXPECT_EQ(work.run({"check", "corpus", "--trials", "t0000000"}).exit_code, 0);
  // A force that counts as contact only above what the sensor hangs at.
  EXPECT_EQ(work.run({"check", "corpus", "--set", "contact_on_n=0.9"}).exit_code, 0);
}

TEST(Pipeline, AKilledRunLeavesNothingUnderTheFinalName) {
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"simulate", "--trials", "200", "--output", "corpus"}));
  for (const int wait_ms : {20, 60, 120}) {
    const pid_t child = work.start({"certify", "corpus", "--quiet", "--output", "out"});
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    if (std::filesystem::exists(work / "out")) {
      EXPECT_EQ(work.files("out/series").size(), 200U) << "there, but not whole";
      std::filesystem::remove_all(work / "out");
    }
  }
  expect_done(work.run({"certify", "corpus", "--output", "out"}));
  EXPECT_EQ(work.files("out/series").size(), 200U);
}

// Table 1 of the paper at the halved cell sizes.
constexpr std::array<std::array<const char*, 4>, 18> kTableOne = {{
    {"CB-V", "Dark", "52", "60"},
    {"CB-V", "Indoor", "26", "30"},
    {"CB-V", "Outdoor", "23", "30"},
    {"M1", "Dark", "24", "30"},
    {"M1", "Indoor", "30", "30"},
    {"M1", "Outdoor", "26", "30"},
    {"M2", "Dark", "27", "30"},
    {"M2", "Indoor", "26", "30"},
    {"M2", "Outdoor", "25", "30"},
    {"M3", "Dark", "53", "60"},
    {"M3", "Indoor", "53", "60"},
    {"M3", "Outdoor", "52", "60"},
    {"TD*Lite", "Dark", "27", "30"},
    {"TD*Lite", "Indoor", "28", "30"},
    {"TD*Lite", "Outdoor", "28", "30"},
    {"TVFH", "Dark", "28", "30"},
    {"TVFH", "Indoor", "27", "30"},
    {"TVFH", "Outdoor", "28", "30"},
}};

TEST(Pipeline, ReproduceMakesTableOneAndSaysThatItIsSynthetic) {
  Workdir work(TCERT_BINARY);
  const ProcessResult run = work.run({"reproduce", "--output", "out", "--no-series"});
  expect_done(run);
  EXPECT_EQ(run.out.find("SYNTHETIC data, seed 1"), 0U);
  const std::string cells = work.read("out/certificates/study_cells.csv");
  for (const auto& [algorithm, lighting, successes, trials] : kTableOne) {
    const std::string row = std::string(algorithm) + "," + lighting + "," + trials + "," + trials +
                            "," + successes + ",";
    EXPECT_NE(cells.find("\n" + row), std::string::npos) << row << " is not in\n" << cells;
  }
  EXPECT_NE(cells.find("660,660,583,"), std::string::npos);
  // As the paper has it: a row an algorithm, a column a lighting, and sums.
  const std::string table = work.read("out/certificates/table1.txt");
  for (const char* const row :
       {"algorithm  Dark              Indoor            Outdoor           all",
        "CB-V       52/60 (86.7 %)    26/30 (86.7 %)    23/30 (76.7 %)    101/120 (84.2 %)",
        "all        211/240 (87.9 %)  190/210 (90.5 %)  182/210 (86.7 %)  583/660 (88.3 %)"}) {
    EXPECT_NE(table.find(row), std::string::npos) << row << " is not in\n" << table;
  }
  EXPECT_NE(work.read("out/certificates/speed.txt").find("Policy-loop latency: median 19.6 ms; "),
            std::string::npos);
  for (const char* const part : {"certificates", "h1", "h2", "h3", "replays", "ablation", "gate"}) {
    for (const std::string& file : work.files(std::string("out/") + part)) {
      const std::string text = work.read(std::string("out/") + part + "/" + file);
      EXPECT_TRUE(text.find("SYNTHETIC") != std::string::npos ||
                  text.find("synthetic") != std::string::npos)
          << part << '/' << file;
    }
  }
  // Nothing is made anew, and nothing changes.
  const std::string manifest = work.read("out/certificates/manifest.json");
  expect_done(work.run({"reproduce", "--output", "out", "--no-series", "--no-driven"}));
  EXPECT_EQ(work.read("out/certificates/manifest.json"), manifest);
  EXPECT_EQ(manifest.find(work.path().string()), std::string::npos) << "a machine's path";
}

TEST(Pipeline, ARealRobotsLogHasACertificate) {
  const auto log = test_support::shared_data() / "carmen-intel/intel.gfs.log.gz";
  if (!std::filesystem::exists(log)) {
    GTEST_SKIP() << "no real data: " << log << " is missing";
  }
  Workdir work(TCERT_BINARY);
  expect_done(work.run({"import",
                        "carmen",
                        log.string(),
                        "--output",
                        "intel",
                        "--goal-x=-0.81",
                        "--goal-y=-15.87"}));
  expect_done(work.run({"certify", "intel", "--output", "out", "--format", "json"}));
  const std::string certificates = work.read("out/certificates.csv");
  EXPECT_NE(certificates.find(",1,"), std::string::npos) << certificates;
  // The door of 1.06 m in the west corridor, passed northward: beam 161 of 0.62 m, 71 degrees to
  // the left, and beam 45 of 0.67 m, 45 degrees to the right, less the body of 0.45 m.
  EXPECT_NE(certificates.find("-6.04"), std::string::npos) << certificates;
  const double degree = std::acos(-1.0) / 180.0;
  const double margin = 0.62 * std::sin(71.0 * degree) + 0.67 * std::sin(45.0 * degree) - 0.45;
  const table::TextTableResult table = table::read_text_table(work.path() / "out/certificates.csv");
  ASSERT_TRUE(table.table);
  EXPECT_NEAR(
      std::stod(table.table->at(0, table.table->find("certificate_m").value())), margin, 1e-9);
}

/// What run.py of the challenge appends, from any number of files.
TEST(Pipeline, BarnResultTextOfSeveralPlannersBecomesOneTable) {
  Workdir work(TCERT_BINARY);
  work.write("dwa_out.txt", "0 1 0 0 22.2800 4.1806\n301 1 0 0 20 4\n0 0 1 0 5.5\n");
  work.write("res/lics-out.txt", "0 0 0 1 100.0 0\n");
  work.write("out.txt", "0 1 0 0 9.5 1\n");
  work.write("metrics.csv", "world,m1,m2,m3,m4,m5\n0,1,2,3,4,5\n");
  const std::string header = "planner,world,success,collided,timeout,time_s,m1,m2,m3,m4,m5\n";
  const std::string dwa = "dwa,0,1,0,0,22.2800,1,2,3,4,5\ndwa,0,0,1,0,5.5,1,2,3,4,5\n";
  const std::string lics = "lics,0,0,0,1,100.0,1,2,3,4,5\n";
  const std::vector<std::string> end{"--metrics", "metrics.csv", "--output", "a.csv"};
  const auto import = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"import", "barn"});
    arguments.insert(arguments.end(), end.begin(), end.end());
    return work.run(arguments);
  };
  expect_done(import({"--trials", "dwa_out.txt", "res/lics-out.txt"}));
  EXPECT_EQ(work.read("a.csv"), header + dwa + lics);
  expect_done(work.run({"verify", "a.csv", "--inputs", "res"}));
  expect_done(import({"--trials", "res/lics-out.txt", "--trials", "dwa_out.txt"}));
  EXPECT_EQ(work.read("a.csv"), header + lics + dwa);
  expect_done(import({"--trials", "out.txt", "--planner", "mine"}));
  EXPECT_EQ(work.read("a.csv"), header + "mine,0,1,0,0,9.5,1,2,3,4,5\n");
  expect_done(import({"--trials", "dwa_out.txt", "res/lics-out.txt", "--planners", "lics"}));
  EXPECT_EQ(work.read("a.csv"), header + lics);
  const ProcessResult nameless = import({"--trials", "out.txt"});
  EXPECT_EQ(nameless.exit_code, 2);
  EXPECT_NE(nameless.err.find("'out.txt' names no planner: --planner NAME"), std::string::npos)
      << to_string(nameless);
  work.write("table.csv", "planner,world,success,collided,timeout,time_s\ndwa,0,1,0,0,2\n");
  EXPECT_EQ(import({"--trials", "table.csv", "--planner", "x"}).exit_code, 2);
  expect_done(import({"--trials", "table.csv", "res/lics-out.txt"}));
  EXPECT_EQ(work.read("a.csv"), header + "dwa,0,1,0,0,2,1,2,3,4,5\n" + lics);
  // Numbers that are no result text: the advice is to name the columns.
  work.write("numbers.txt", "1 1 0 0\n2 1 0 0\n");
  const ProcessResult headless = import({"--trials", "numbers.txt"});
  EXPECT_EQ(headless.exit_code, 65);
  EXPECT_NE(headless.err.find("found 'numbers where the names of columns should be', expected a "
                              "header line before the rows, which names world"),
            std::string::npos)
      << to_string(headless);
  EXPECT_EQ(headless.err.find("case is folded"), std::string::npos);
}

TEST(Pipeline, BarnOutcomesBecomeOneTable) {
  Workdir work(TCERT_BINARY);
  work.write("trials.csv",
             "planner,world,success,collided,timeout,time_s\n"
             "dwa,0,1,0,0,22.5\n"
             "dwa,301,1,0,0,20\n"
             "ros2_maity,0,0,1,0,3\n");
  work.write("metrics.csv", "world,m1,m2,m3,m4,m5\n0,1,2,3,4,5\n");
  std::vector<std::string> arguments{
      "import", "barn", "--trials", "trials.csv", "--metrics", "metrics.csv", "--output", "a.csv"};
  const ProcessResult run = work.run(arguments);
  expect_done(run);
  EXPECT_NE(run.err.find("2 of 3 trials written: 1 successes, 1 worlds"), std::string::npos)
      << to_string(run);
  EXPECT_EQ(work.read("a.csv"),
            "planner,world,success,collided,timeout,time_s,m1,m2,m3,m4,m5\n"
            "dwa,0,1,0,0,22.5,1,2,3,4,5\n"
            "ros2_maity,0,0,1,0,3,1,2,3,4,5\n");
  EXPECT_NE(work.read("a.csv.manifest.json").find("metrics.csv"), std::string::npos);
  arguments.insert(arguments.end(), {"--same-port", "--planners", "dwaa"});
  EXPECT_NE(work.run(arguments).err.find("did you mean 'dwa'?"), std::string::npos);
  arguments.back() = "dwa";
  expect_done(work.run(arguments));
  work.write("trials.csv",
             "planner,world,success,collided,timeout,time_s\ndwa,0,1,0,0,22.5\ndwa,0,1,0,0,-1\n");
  EXPECT_EQ(work.run(arguments).exit_code, 3) << "a row was rejected";
  EXPECT_EQ(work.run({"import", "bran", "x"}).exit_code, 2);
}

}  // namespace
}  // namespace tcert
