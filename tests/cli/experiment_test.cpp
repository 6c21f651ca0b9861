// Batches of cells as processes: the same as by hand, whatever the cache, the threads and the
// kills.

#include <gtest/gtest.h>

#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

class Experiment : public ::testing::Test {
 protected:
  void SetUp() override { done({"simulate", "--trials", "66", "--output", "corpus"}); }

  ProcessResult done(const std::vector<std::string>& arguments) {
    ProcessResult run = work.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run;
  }

  static std::vector<std::string> joined(std::vector<std::string> a,
                                         const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }

  void expect_same_folders(const std::string& a, const std::string& b) const {
    const auto files = work.files(a);
    EXPECT_FALSE(files.empty());
    ASSERT_EQ(files, work.files(b));
    for (const std::string& file : files) {
      EXPECT_TRUE(work.read(a + "/" + file) == work.read(b + "/" + file)) << file << " differs";
    }
  }

  /// Name of the features file of a cell, by files.csv.
  [[nodiscard]] std::string features_of(const std::string& folder, const std::string& cell) const {
    std::istringstream lines(work.read(folder + "/files.csv"));
    for (std::string line; std::getline(lines, line);) {
      const std::string start = cell + ",";
      if (line.rfind(start, 0) == 0) {
        return folder + "/" +
               line.substr(start.size(), line.find(',', start.size()) - start.size());
      }
    }
    return {};
  }

  Workdir work{TCERT_BINARY};
};

TEST_F(Experiment, AnAblationIsWhatSetGivesByHand) {
  done({"ablate", "corpus", "--replicates", "50", "--cache", "cache", "--output", "ablation"});
  const std::vector<std::pair<std::string, std::vector<std::string>>> by_hand = {
      {"full", {}},
      {"A1", {"--set", "memory_weight_m=0"}},
      {"A2", {"--set", "unknown=free"}},
      {"A1+A3", {"--set", "memory_weight_m=0", "--set", "curvature=none"}}};
  for (const auto& [cell, flags] : by_hand) {
    done(joined({"certify", "corpus", "--no-series", "--output", "hand_" + cell}, flags));
    EXPECT_TRUE(work.read(features_of("ablation", cell)) ==
                work.read("hand_" + cell + "/features.csv"))
        << cell;
  }
}

TEST_F(Experiment, CacheThreadsAndKillsDoNotChangeAByte) {
  const std::vector<std::string> sweep = {"sweep",
                                          "corpus",
                                          "--grid",
                                          "memory_weight_m=0,0.05,0.2",
                                          "--grid",
                                          "early_quantile=0,0.1",
                                          "--replicates",
                                          "50"};
  done(joined(sweep, {"--cache", "c1", "--threads", "1", "--output", "cold"}));
  const ProcessResult warm =
      done(joined(sweep, {"--cache", "c1", "--threads", "2", "--output", "warm"}));
  EXPECT_NE(warm.err.find(" 0 made"), std::string::npos) << warm.err;
  done(joined(sweep, {"--no-cache", "--output", "without"}));
  expect_same_folders("cold", "warm");
  expect_same_folders("cold", "without");

  for (const int milliseconds : {20, 60, 150, 300}) {
    const pid_t child = work.start(joined(sweep, {"--cache", "c2", "--output", "killed"}));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
  }
  if (work.files("killed").empty()) {
    done(joined(sweep, {"--cache", "c2", "--output", "killed"}));
  }
  expect_same_folders("cold", "killed");
}

TEST_F(Experiment, ADamagedEntryIsMadeAgain) {
  const std::vector<std::string> sweep = {
      "sweep", "corpus", "--grid", "early_quantile=0.2", "--replicates", "20", "--cache", "cache"};
  done(joined(sweep, {"--output", "first"}));
  for (const std::string& file : work.files("cache")) {
    work.write("cache/" + file, work.read("cache/" + file) + "x");
  }
  done(joined(sweep, {"--output", "second"}));
  expect_same_folders("first", "second");
}

TEST_F(Experiment, AnImpossibleCellIsRefusedAndTheRestRuns) {
  work.write("cells.csv",
             "cell,min_speed_mps,beta_per_m,memory_half_life_s\nslow,0.5,,\nflat,,0,\nback,,,-3\n"
             "good,,5,\n");
  const ProcessResult run = work.run({"sweep",
                                      "corpus",
                                      "--cells",
                                      "cells.csv",
                                      "--replicates",
                                      "20",
                                      "--no-cache",
                                      "--format",
                                      "csv"});
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  for (const char* reason : {"slow' is refused", "flat' is refused", "back' is refused"}) {
    EXPECT_NE(run.err.find(reason), std::string::npos) << run.err;
  }
  EXPECT_NE(run.out.find("\ngood,"), std::string::npos) << run.out;
}

TEST_F(Experiment, AGridIsCheckedWholeBeforeAnythingRuns) {
  const auto refused = [&](const std::vector<std::string>& grid, const std::string& words) {
    const ProcessResult run = work.run(
        joined({"sweep", "corpus", "--no-cache", "--output", "swept"}, joined({"--grid"}, grid)));
    EXPECT_EQ(run.exit_code, 2) << to_string(run);
    EXPECT_NE(run.err.find(words), std::string::npos) << run.err;
    EXPECT_TRUE(work.files("swept").empty());
  };
  // The last value of the last axis, after values that are good.
  refused({"early_quantile=0,0.1", "--grid", "beta_per_m=5,10,0"}, "--grid: beta_per_m=0: ");
  refused({"curvature=path,paht"}, "--grid: curvature=paht: ");
  refused({"erly_quantile=0"}, "did you mean 'early_quantile'?");
  // In its own bounds, but not with those of the other sizes.
  refused({"min_speed_mps=0.05,1000"}, "--grid: min_speed_mps=1000: ");
  std::string many = "=0";
  for (int i = 1; i < 101; ++i) {
    many += "," + std::to_string(i);
  }
  refused({"early_time_s" + many, "--grid", "beta_per_m" + many}, "more than 10000 combinations");
}

TEST_F(Experiment, OfAGridCombinationsAreRefusedWhoseValuesAreFineApart) {
  const ProcessResult run = work.run({"sweep",
                                      "corpus",
                                      "--no-cache",
                                      "--replicates",
                                      "20",
                                      "--grid",
                                      "min_speed_mps=0.05,0.2",
                                      "--grid",
                                      "max_speed_mps=0.1,0.3"});
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  EXPECT_NE(run.err.find("cell 'min_speed_mps=0.2 max_speed_mps=0.1' is refused"),
            std::string::npos)
      << run.err;
}

}  // namespace
}  // namespace tcert
