// Batches as processes: the result of parts is that of one process, whatever the shards; what is
// missing, foreign or damaged is said and never merged.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "support/shell.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

constexpr const char* kWorlds = "soundness --worlds 20 --hard 9 --u-turns 4 --driven 2";

/// Every command ends well.
void expect_done(Shell& shell, const std::string& line) {
  const ProcessResult run = shell.run("set -e; " + line);
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
}

std::string plan(const std::string& command, int shards, const std::string& name) {
  return "$T batch plan " + command + " --quiet --shards " + std::to_string(shards) + " --output " +
         name + "; ";
}

std::string work(const std::string& name, int shards) {
  return "for i in $(seq 0 " + std::to_string(shards - 1) + "); do $T batch work " + name +
         " --quiet --shard $i/" + std::to_string(shards) + "; done; ";
}

std::string merge(const std::string& name) { return "$T batch merge " + name + " --quiet; "; }

void expect_refused(Shell& shell, const std::string& line, int code, const std::string& why) {
  const ProcessResult run = shell.run(line);
  EXPECT_EQ(run.exit_code, code) << to_string(run);
  EXPECT_NE(run.err.find(why), std::string::npos) << to_string(run);
}

TEST(BatchCommand, StudiesComeToWhatOneProcessComesTo) {
  Shell shell;
  const std::vector<std::string> studies{kWorlds,
                                         "soundness --witness --worlds 4 --hard 2 --u-turns 1",
                                         "coverage --data-sets 6 --replicates 19",
                                         "inference --data-sets 2 --replicates 19",
                                         "gate --data-sets 6 --replicates 19",
                                         "rays --data-sets 30",
                                         "terrain --terrains 5"};
  int number = 0;
  for (const std::string& study : studies) {
    const std::string name = "s" + std::to_string(number++);
    expect_done(shell, "$T study " + study + " --quiet --output one-" + name + "/");
    for (const int shards : {1, 5}) {
      const std::string of = name + "-" + std::to_string(shards);
      expect_done(shell,
                  plan(shards == 1 ? study : "study " + study, shards, of) + work(of, shards) +
                      merge(of) + "diff -r one-" + name + " " + of + "/result");
    }
  }
}

TEST(BatchCommand, CellsComeToWhatOneProcessComesTo) {
  Shell shell;
  expect_done(shell, "$T simulate --trials 12 --quiet --output corpus");
  const std::string grid =
      "sweep corpus --replicates 20 --grid memory_weight_m=0,0.05 --grid early_quantile=0,0.1 ";
  expect_done(shell, "$T " + grid + "--no-cache --quiet --output grid");
  expect_done(shell, "$T ablate corpus --replicates 20 --no-cache --quiet --output ablation");
  for (const int shards : {1, 3, 11}) {
    const std::string of = std::to_string(shards);
    expect_done(shell,
                "export XDG_CACHE_HOME=$PWD/cache-" + of + "; " + plan(grid, shards, "g" + of) +
                    work("g" + of, shards) + merge("g" + of) + "diff -r grid g" + of + "/result; " +
                    plan("ablate corpus --replicates 20", shards, "a" + of) +
                    work("a" + of, shards) + merge("a" + of) + "diff -r ablation a" + of +
                    "/result");
  }
  expect_done(shell, "$T verify grid --inputs . --quiet; $T verify g3/result --inputs . --quiet");
  expect_done(shell, "echo >> corpus/trials.csv");
  expect_refused(shell, merge("g3"), 65, "is not what it was when the plan was made");
}

TEST(BatchCommand, TrialsComeToTheFeaturesOfTheirBundle) {
  Shell shell;
  for (const std::string command : {"simulate --trials 9 --from 655 --effect 0.5",
                                    "drive --trials 7 --from 3",
                                    "drive --worlds 2 --from 1 --policies M3,M3+squash20"}) {
    const std::string name = "made" + std::to_string(command.size());
    expect_done(shell,
                "$T " + command + " --quiet --output " + name + "; $T certify " + name +
                    " --no-series --quiet --output " + name + "-certified; " +
                    plan(command, 3, name + "-plan") + work(name + "-plan", 3) +
                    merge(name + "-plan") + "cmp " + name + "-certified/features.csv " + name +
                    "-plan/result/features.csv; $T verify " + name + "-plan/result --quiet");
  }
  expect_done(
      shell,
      "$T simulate --trials 9 --quiet --output all; $T simulate --trials 3 --from 6 --quiet "
      "--output rest; for i in 6 7 8; do diff -r all/logs/t000000$i rest/logs/t000000$i; "
      "diff all/worlds/t000000$i.json rest/worlds/t000000$i.json; done");
}

TEST(BatchCommand, WhatIsMissingIsSaidAndMadeAlone) {
  Shell shell;
  expect_done(shell, plan(kWorlds, 4, "p") + "rm -f p/parts/*; " + "$T batch work p --shard 1/4");
  const ProcessResult run = shell.run("$T batch merge p");
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  EXPECT_NE(run.err.find("3 of 4 shards missing: 0, 2 to 3"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("sh p/submit"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("sh p/run_parallel"), std::string::npos) << run.err;
  EXPECT_FALSE(std::filesystem::exists(shell.work() / "p/result"));

  const ProcessResult part = shell.run("$T batch merge p --partial");
  EXPECT_EQ(part.exit_code, 3) << to_string(part);
  EXPECT_NE(part.out.find("# PARTIAL: 3 of 4 shards missing"), std::string::npos) << part.out;
  EXPECT_NE(part.out.find("hard"), std::string::npos) << part.out;
  EXPECT_FALSE(std::filesystem::exists(shell.work() / "p/result"));
  expect_refused(shell, "$T batch merge p --partial --output o/", 2, "--partial");

  expect_done(shell, work("p", 4) + merge("p"));
  const ProcessResult again = shell.run("$T batch work p --shard 1/4");
  EXPECT_NE(again.err.find("there already"), std::string::npos) << to_string(again);
}

TEST(BatchCommand, ShardsAreNamedWithTheirNumberOrByAJobArray) {
  Shell shell;
  expect_done(shell, plan(kWorlds, 4, "p"));
  expect_refused(shell, "$T batch work p", 2, "needs --shard I/N");
  expect_refused(shell, "$T batch work p --shard 3", 2, "expected I/N, such as 0/4");
  expect_refused(shell, "$T batch work p --shard -1/4", 2, "expected I/N");
  expect_refused(shell, "$T batch work p --shard 3/8", 2, "found 8 shards, the plan has 4");
  expect_refused(shell, "$T batch work p --shard 4/4", 2, "which has 0 to 3");
  expect_refused(shell, "SGE_TASK_ID=undefined $T batch work p", 2, "needs --shard I/N");
  expect_done(shell,
              "SLURM_ARRAY_TASK_ID=1 $T batch work p --offset 2; test -f p/parts/000003.csv; "
              "SGE_TASK_ID=1 $T batch work p; test -f p/parts/000000.csv");
  expect_refused(shell, "SLURM_ARRAY_TASK_ID=1 $T batch work p --offset 3", 2, "none of the plan");
}

TEST(BatchCommand, PartsThatAreDamagedOrForeignAreRefused) {
  Shell shell;
  expect_done(shell,
              plan(kWorlds, 3, "p") + work("p", 3) + plan("terrain --terrains 3", 3, "q") +
                  work("q", 3) + "cp p/parts/000001.csv good");
  const auto with = [&](const std::string& spoil, const std::string& why) {
    for (const std::string& step : {merge("p"), std::string("$T batch work p --shard 1/3")}) {
      expect_refused(shell, "cp good p/parts/000001.csv; " + spoil + "; " + step, 65, why);
    }
    EXPECT_FALSE(std::filesystem::exists(shell.work() / "p/result"));
  };
  const std::string part = "p/parts/000001.csv";
  with("cp q/parts/000001.csv " + part, "is of another plan");
  with("cp p/parts/000002.csv " + part, "is of another shard");
  with("sed -i 's/^# program ./# program x/' " + part, "is of another program");
  with("sed -i 's/^# arithmetic ./# arithmetic x/' " + part, "is of another arithmetic");
  with("head -c 2000 good > " + part, "not whole");
  with("sed -i '$d' " + part, "does not fit");
  with("sed -i '9s/0/1/' " + part, "damaged");
  with("echo >> " + part, "does not fit");
  with("printf x >> " + part, "ends within a line");
  with(": > " + part, "is none of this tool");
  expect_refused(shell, "rm " + part + "; mkdir " + part + "; " + merge("p"), 66, "cannot read");
  expect_refused(
      shell, "rmdir " + part + "; mkfifo " + part + "; " + merge("p"), 66, "cannot read");
  expect_done(shell, "rm " + part + "; cp good " + part + "; " + merge("p"));
}

TEST(BatchCommand, PlansThatAreNoneAreRefused) {
  Shell shell;
  expect_done(shell, plan(kWorlds, 3, "p") + "cp p/plan.json good");
  expect_refused(shell, plan(kWorlds, 3, "p"), 73, "p");
  expect_refused(shell, "$T batch plan " + std::string(kWorlds) + " --output q", 2, "--shards N");
  expect_refused(
      shell, "$T batch plan certify p --shards 2 --output q", 2, "cannot be made in pieces");
  expect_refused(
      shell, "$T batch plan drive --stdio --shards 2 --output q", 2, "which has no pieces");
  expect_refused(shell, "$T batch plan drive --name x --shards 2 --output q", 2, "--name");
  expect_refused(
      shell, "$T batch plan sounness --shards 2 --output q", 2, "did you mean 'soundness'");
  expect_refused(shell, "$T batch plan --shards 2 soundness --output q", 2, "comes first");
  expect_refused(shell, "$T batch plan simulate --micro-study --shards 2 --output q", 2, "at once");
  expect_refused(shell, "$T batch work nothing --shard 0/1", 66, "plan");
  const auto with = [&](const std::string& spoil, const std::string& why) {
    expect_refused(
        shell, "cp good p/plan.json; " + spoil + "; $T batch work p --shard 0/3", 65, why);
  };
  with("sed -i 's/\"shards\": 3/\"shards\": 0/' p/plan.json", "out of their ranges");
  with("sed -i 's/\"shards\": 3/\"shards\": -3/' p/plan.json", "no plan");
  with("sed -i 's/\"shards\": 3/\"shards\": 3.7/' p/plan.json", "no plan");
  with("sed -i 's/\"plan\": 1/\"plan\": 2/' p/plan.json", "another version");
  with("sed -i 's/\"count\": 9/\"count\": 18446744073709551615/' p/plan.json", "out of their");
  with("sed -i 's/\"count\": 9/\"count\": 90/' p/plan.json", "other items");
  with("sed -i 's/--worlds/--output/' p/plan.json", "nothing is run");
  with("sed -i 's/\"study\"/\"certify\"/' p/plan.json", "no command that works in pieces");
  with("sed -i 's/\"program\": \"./&x/' p/plan.json", "another program");
  with("sed -i 's/\"arithmetic\": \"./&x/' p/plan.json", "computes exp");
  with("echo '{' > p/plan.json", "no plan");
  EXPECT_TRUE(std::filesystem::is_empty(shell.work() / "p/parts"));
}

TEST(BatchCommand, ScriptsFindTheirFolderWhateverItIsCalled) {
  Shell shell;
  const std::string name = R"(it's 100% d\$HOME {} \"q\" a)";
  expect_done(
      shell,
      "mkdir bin; for c in parallel sbatch; do printf '%s\\n' '#!/bin/sh' "
      "'printf \"%s|\" \"$@\" >> ../called; cat >> ../called' > bin/$c; chmod +x bin/$c; done; "
      "export PATH=$PWD/bin:$PATH; " +
          plan(kWorlds, 3, "p") + "mv p \"" + name + "\"; cd \"" + name +
          "\"; sh one 1; test -f parts/000001.csv; sh run_parallel --jobs 2 < /dev/null; "
          "sh ./submit --time=1 < /dev/null; grep -q '^--jobs|2|sh|./one|0$' ../called; "
          "grep -q -- '--array=0,2|' ../called; grep -q '100%% d' ../called");
}

TEST(BatchCommand, InputsAreThoseThatTheCommandReads) {
  Shell shell;
  expect_done(shell,
              "mkdir -p real/sub; ln -s real/sub link; $T simulate --trials 4 --quiet --output "
              "real/named; $T simulate --trials 6 --quiet --output named; $T ablate link/../named "
              "--replicates 9 --no-cache --quiet --output one; " +
                  plan("ablate link/../named --replicates 9", 2, "p") + work("p", 2) + merge("p") +
                  "diff -r one p/result");
  expect_refused(shell, plan("ablate named", 2, "named/plan"), 2, "lies in its input");
  expect_refused(shell,
                 "$T batch plan ablate named --no-cache --shards 2 --output q",
                 2,
                 "does not shape a result");
  expect_refused(
      shell, "$T batch plan ablate named --table nope --shards 2 --output q", 2, "--table");
  expect_refused(shell,
                 plan("ablate named --cluster nosuch", 1, "q") + "$T batch work q --shard 0/1",
                 2,
                 "nosuch");
  // A byte that is no UTF-8 comes through.
  expect_done(
      shell,
      "sed -i 's/,M1,/,M\\xe9,/' named/trials.csv; $T ablate named --replicates 9 --no-cache "
      "--quiet --output latin; " +
          plan("ablate named --replicates 9", 3, "r") + work("r", 3) + merge("r") +
          "diff -r latin r/result");
}

TEST(BatchCommand, ItemsAreDealtToShardsInOrderAndEvenly) {
  Shell shell;
  expect_done(shell, plan("terrain --terrains 3", 7, "p") + work("p", 7));
  std::size_t fewest = 100;
  std::size_t most = 0;
  for (int shard = 0; shard < 7; ++shard) {
    const std::string part = shell.work().read("p/parts/00000" + std::to_string(shard) + ".csv");
    const auto lines = static_cast<std::size_t>(std::count(part.begin(), part.end(), '\n')) - 7;
    fewest = std::min(fewest, lines);
    most = std::max(most, lines);
  }
  EXPECT_LE(most - fewest, 1U);
}

}  // namespace
}  // namespace tcert
