#include <gtest/gtest.h>

#include <string>

#include "support/shell.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

class Footing : public ::testing::Test {
 protected:
  void SetUp() override {
    done(
        "$T drive --policies M1 --worlds 3 --set drive_ramp_share=1 --set drive_step_share=1 "
        "--set drive_time_limit_s=40 --output rough --quiet");
  }
  ProcessResult done(const std::string& line) {
    ProcessResult run = shell_.run(line);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run;
  }
  [[nodiscard]] std::string read(const std::string& name) { return shell_.work().read(name); }

  Shell shell_;
};

TEST_F(Footing, IsInTheLogAndBoundsTheSeriesAlikeInBatchAndLive) {
  EXPECT_EQ(done("$T check rough").out.find("degrees"), std::string::npos);
  done("$T certify rough --ticks --output felt --quiet");
  done("$T certify rough --set footing=ignored --output plane --quiet");
  const std::string first = done("basename -s .csv $(ls felt/series | head -1)").out;
  const std::string trial = first.substr(0, first.find('\n'));
  const std::string pose = read("rough/logs/" + trial + "/pose.csv");
  EXPECT_NE(pose.find("pitch_rad,roll_rad,step_m,slip"), std::string::npos);
  EXPECT_NE(read("felt/series/" + trial + ".csv"), read("plane/series/" + trial + ".csv"));
  done("$T live --bundle rough --record again < felt/ticks/" + trial + ".csv > live.csv");
  EXPECT_EQ(read("live.csv"), read("felt/series/" + trial + ".csv"));
  done("$T certify again --output recorded --quiet");
  EXPECT_EQ(read("recorded/series/live.csv"), read("felt/series/" + trial + ".csv"));
}

TEST_F(Footing, IsTheAblationA4WhereALogHasIt) {
  const std::string rough = done("$T ablate rough --table issuance --format csv --no-cache").out;
  EXPECT_NE(rough.find("A4"), std::string::npos) << rough;
  done("$T drive --policies M1 --worlds 3 --set drive_time_limit_s=40 --output level --quiet");
  EXPECT_EQ(done("$T ablate level --table issuance --format csv --no-cache").out.find("A4"),
            std::string::npos);
}

TEST(MovingObstaclesCommand, AddATimeOfValidityAndChangeNothingAtSpeed0) {
  Shell shell;
  const auto done = [&](const std::string& line) {
    const ProcessResult run = shell.run(line);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    return run;
  };
  done("$T simulate --trials 12 --output corpus --quiet");
  done("$T certify corpus --output still --ticks --quiet");
  done("$T certify corpus --set obstacle_speed_mps=0 --output zero --quiet");
  done("$T certify corpus --set obstacle_speed_mps=0.002 --output moving --quiet");
  EXPECT_EQ(done("diff -r still/series zero/series && diff -r still/edges zero/edges").out, "");
  const std::string name = done("ls moving/series | head -1").out;
  const std::string file = name.substr(0, name.find('\n'));
  const std::string moving = shell.work().read("moving/series/" + file);
  EXPECT_NE(moving.substr(0, moving.find('\n')).find(",valid_for_s"), std::string::npos);
  done("$T live --bundle corpus --set obstacle_speed_mps=0.002 < still/ticks/" + file +
       " > live.csv");
  EXPECT_EQ(shell.work().read("live.csv"), moving);
  const ProcessResult swept =
      shell.run("$T certify corpus --set obstacle_speed_mps=0.1 --set clearance=swept");
  EXPECT_EQ(swept.exit_code, 2) << to_string(swept);
  EXPECT_NE(swept.err.find("what was swept has no time"), std::string::npos) << swept.err;
  for (const std::string proof : {"submaps", "witness", "witness-edges"}) {
    const ProcessResult told =
        shell.run("$T certify corpus --set obstacle_speed_mps=0.1 --output x --" + proof);
    EXPECT_EQ(told.exit_code, 2) << to_string(told);
    EXPECT_NE(told.err.find("say nothing of time"), std::string::npos) << told.err;
  }
}

}  // namespace
}  // namespace tcert
