/// Closed descriptors, pipes and devices in the place of files, full disks, and other surroundings.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "support/shell.hpp"

namespace tcert {
namespace {

namespace fs = std::filesystem;
using test_support::ProcessResult;
using test_support::Shell;

/// A corpus of six trials and what is made of it.
class Surroundings : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shell = std::make_unique<Shell>();
    const ProcessResult run = shell->run(
        "$T simulate --trials 6 --output corpus && $T certify corpus --ticks --output made && "
        "sed '$d' made/ticks/t0000000.csv > ticks.csv");
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
  }
  static void TearDownTestSuite() { shell.reset(); }

  static std::unique_ptr<Shell> shell;
};

std::unique_ptr<Shell> Surroundings::shell;

TEST_F(Surroundings, NoWordLandsInAResultWhateverIsClosed) {
  // A warning is said while features.csv is written.
  ASSERT_EQ(shell->run("cp -r corpus worse && echo junk > worse/logs/t0000002/pose.csv").exit_code,
            0);
  const auto expected = [&] {
    EXPECT_EQ(shell->run("rm -rf open; $T certify worse --output open").exit_code, 3);
    return shell->contents("open");
  }();
  ASSERT_GT(expected.size(), 10U);
  for (const char* closed : {"2>&-", ">&-", "<&-", "<&- >&-", "<&- >&- 2>&-", ">&- 2>&-"}) {
    const ProcessResult run = shell->run(std::string("rm -rf closed; timeout 30 $T certify worse "
                                                     "--output closed ") +
                                         closed);
    EXPECT_EQ(run.exit_code, 3) << closed << to_string(run);
    EXPECT_EQ(shell->contents("closed"), expected) << closed;
  }
}

TEST_F(Surroundings, LiveWithoutStdoutRecordsWhatItWouldAndEnds) {
  const ProcessResult run = shell->run(
      "$T live --bundle corpus --record one < ticks.csv > rows.csv && "
      "timeout 30 $T live --bundle corpus --record two < ticks.csv >&- && "
      "timeout 30 $T live --bundle corpus --record three < ticks.csv >&- 2>&-");
  ASSERT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_EQ(shell->contents("one"), shell->contents("two"));
  EXPECT_EQ(shell->contents("one"), shell->contents("three"));
}

TEST_F(Surroundings, APipeIsNoFileAndIsNotWaitedFor) {
  ASSERT_EQ(shell
                ->run("mkfifo pipe pipe.json && mkdir -p piped/logs && mkfifo piped/bundle.json && "
                      "mkfifo piped/trials.csv")
                .exit_code,
            0);
  for (const char* line : {"$T certify pipe",
                           "$T certify piped",
                           "$T check pipe",
                           "$T fit glm --data pipe --formula 'y ~ x'",
                           "$T certify corpus --config pipe",
                           "$T world pipe.json",
                           "$T explore pipe --start 1,1",
                           "$T hypotheses h1 --features pipe",
                           "$T live --bundle pipe.json < ticks.csv",
                           "$T verify pipe",
                           "$T figures pipe --output drawn"}) {
    const ProcessResult run = shell->run(std::string("timeout 20 ") + line);
    EXPECT_TRUE(run.exit_code == 65 || run.exit_code == 66) << to_string(run);
  }
  for (const char* line : {"$T certify corpus --output pipe",
                           "$T simulate --output pipe",
                           "$T hypotheses h1 --features made/features.csv --output pipe",
                           "$T world corpus/worlds/*.json --output pipe",
                           "$T simulate terrain --output /dev/null",
                           "$T live --bundle corpus --record pipe < ticks.csv",
                           "$T live --bundle corpus --audit pipe < ticks.csv"}) {
    const ProcessResult run = shell->run(std::string("timeout 20 ") + line);
    EXPECT_EQ(run.exit_code, 73) << to_string(run);
    EXPECT_NE(run.err.find("pipe, a socket or a device"), std::string::npos) << to_string(run);
  }
  EXPECT_TRUE(fs::is_fifo(shell->work() / "pipe"));
  EXPECT_FALSE(fs::exists("/dev/null.manifest.json"));
}

TEST_F(Surroundings, AnOutputThatIsALinkIsFoundBeforeTheWork) {
  const ProcessResult run = shell->run(
      "mkdir -p target && ln -s target link && $T certify corpus --output link/ ; "
      "echo $? ; $T simulate terrain --rows 4 --columns 4 --output link; echo $?");
  EXPECT_EQ(run.out, "73\n73\n") << to_string(run);
  EXPECT_NE(run.err.find("it is a link"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("Certified"), std::string::npos) << "nothing was worked for";
  EXPECT_TRUE(fs::is_empty(shell->work() / "target"));
}

TEST_F(Surroundings, ACacheIsAConvenience) {
  const auto batch = [&](const std::string& surroundings, const std::string& options) {
    return shell->run("rm -rf out; " + surroundings +
                      " $T ablate corpus --replicates 20 --output out " + options);
  };
  ASSERT_EQ(batch("", "--no-cache").exit_code, 0);
  const auto expected = shell->contents("out");
  ASSERT_FALSE(expected.empty());
  shell->work().write("file", "");
  for (const auto& [surroundings, options] : {std::pair("env -u HOME -u XDG_CACHE_HOME", ""),
                                              std::pair("env -u XDG_CACHE_HOME HOME=$PWD/file", ""),
                                              std::pair("env XDG_CACHE_HOME=/proc/none", ""),
                                              std::pair("", "--cache file/below"),
                                              std::pair("", "--cache /proc/none")}) {
    const ProcessResult run = batch(surroundings, options);
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    const auto first = run.err.find("warning: nothing is kept");
    EXPECT_NE(first, std::string::npos) << to_string(run);
    EXPECT_EQ(run.err.find("warning: nothing is kept", first + 1), std::string::npos) << run.err;
    EXPECT_EQ(shell->contents("out"), expected) << surroundings << options;
  }
}

TEST_F(Surroundings, AFileThatMayNotGrowLeavesNothing) {
  const ProcessResult run =
      shell->run("(ulimit -f 8; $T certify corpus --output short); echo $?; ls -A | grep short");
  EXPECT_EQ(run.out, "73\n") << to_string(run);
}

TEST_F(Surroundings, TooFewDescriptorsEndTheRunAndRejectNoTrial) {
  const ProcessResult run = shell->run("(ulimit -n 9; $T certify corpus --threads 2 --output few)");
  EXPECT_EQ(run.err.find("rejected"), std::string::npos) << run.err;
  EXPECT_TRUE(run.exit_code == 71 || run.exit_code == 73 || run.exit_code == 0) << to_string(run);
  EXPECT_TRUE(run.exit_code == 0 || !fs::exists(shell->work() / "few"));
}

TEST_F(Surroundings, ABadTmpdirAndADeletedFolderAreNamed) {
  const ProcessResult run = shell->run("TMPDIR=/nowhere $T verify made --inputs .");
  EXPECT_EQ(run.exit_code, 73) << to_string(run);
  EXPECT_NE(run.err.find("TMPDIR"), std::string::npos) << run.err;
  const ProcessResult gone = shell->run(
      "mkdir gone && cd gone && rmdir ../gone && $T certify ../corpus --output out; echo $?; "
      "$T verify ../made --files-only; echo $?");
  EXPECT_EQ(gone.out.find("70"), std::string::npos) << to_string(gone);
  EXPECT_EQ(gone.err.find("internal error"), std::string::npos) << gone.err;
}

TEST_F(Surroundings, AnAuditLogReplacesNothingElse) {
  const std::string live = "$T live --bundle corpus/bundle.json --guards < ticks.csv > rows.csv ";
  ASSERT_EQ(shell->run(live + "--audit audit.csv").exit_code, 0);
  const std::string audit = shell->work().read("audit.csv");
  EXPECT_EQ(shell->run(live + "--audit audit.csv").exit_code, 0) << "of an earlier run";
  EXPECT_EQ(shell->work().read("audit.csv"), audit);
  shell->work().write("notes.txt", "mine");
  const auto corpus = shell->contents("corpus");
  for (const char* file : {"notes.txt", "corpus/bundle.json", "corpus/trials.csv"}) {
    const ProcessResult run = shell->run(live + "--audit " + file);
    EXPECT_TRUE(run.exit_code == 73 || run.exit_code == 2) << to_string(run);
  }
  EXPECT_EQ(shell->work().read("notes.txt"), "mine");
  EXPECT_EQ(shell->contents("corpus"), corpus);
}

TEST_F(Surroundings, TheLiveLoopOutlivesItsDisk) {
  // A wide body: the guards trip often.
  const std::string live = "$T live --bundle corpus --guards --set body_width_m=0.6 < ticks.csv ";
  ASSERT_EQ(shell->run(live + "--audit audit_all.csv > all.csv").exit_code, 0);
  ASSERT_GT(shell->work().read("audit_all.csv").size(), 600U);
  // Only what is written beside the rows meets the limit: rows and words go through pipes.
  const auto limited = [&](const std::string& blocks, const std::string& option) {
    const ProcessResult run =
        shell->run("( (ulimit -f " + blocks + "; " + live + option +
                   "; echo ended with $? >&2) 2>&1 1>&3 | cat > words.txt ) 3>&1 | cmp - all.csv");
    EXPECT_EQ(run.exit_code, 0) << "every row, as without: " << to_string(run);
    return shell->work().read("words.txt");
  };
  const std::string audited = limited("1", "--audit audit_cut.csv");
  EXPECT_NE(audited.find("cannot write the audit log"), std::string::npos) << audited;
  EXPECT_NE(audited.find("rows of the audit log were lost"), std::string::npos) << audited;
  EXPECT_NE(audited.find("ended with 73"), std::string::npos) << audited;
  const std::string cut = shell->work().read("audit_cut.csv");
  EXPECT_LE(cut.size(), 512U);
  EXPECT_EQ(cut, shell->work().read("audit_all.csv").substr(0, cut.size()));
  EXPECT_TRUE(cut.ends_with('\n')) << "no half row";
  const std::string recorded = limited("16", "--record record_cut");
  EXPECT_NE(recorded.find("recording ended, the run goes on"), std::string::npos) << recorded;
  EXPECT_NE(recorded.find("ticks were not recorded"), std::string::npos) << recorded;
  EXPECT_NE(recorded.find("ended with 73"), std::string::npos) << recorded;
}

TEST_F(Surroundings, TheLiveLoopOutlivesTheDiskOfItsRows) {
  const std::string live = "timeout 30 $T live --bundle corpus < ticks.csv ";
  ASSERT_EQ(shell->run(live + "--record whole > all.csv").exit_code, 0);
  const ProcessResult full = shell->run(live + "--record full > /dev/full");
  EXPECT_EQ(full.exit_code, 73) << to_string(full);
  EXPECT_NE(full.err.find("cannot write to stdout"), std::string::npos) << full.err;
  EXPECT_NE(full.err.find("rows were lost"), std::string::npos) << full.err;
  EXPECT_EQ(shell->contents("full"), shell->contents("whole")) << "every tick was taken";
  const ProcessResult cut = shell->run("(ulimit -f 4; " + live + "> cut.csv)");
  EXPECT_EQ(cut.exit_code, 73) << to_string(cut);
  const std::string rows = shell->work().read("cut.csv");
  EXPECT_EQ(rows, shell->work().read("all.csv").substr(0, rows.size()));
  EXPECT_GT(rows.size(), 1024U);
}

TEST_F(Surroundings, WhatATerminalWouldObeyIsSaidInOtherWords) {
  shell->work().write("esc/trials.csv",
                      "trial_id,success,time_s\n\x1b[31mred,1,2\nt\x1b]0;x,1,2\n");
  const ProcessResult run = shell->run(
      "cp corpus/bundle.json esc/ && mkdir -p esc/logs; $T certify esc; "
      "$T hypotheses h1 --features \"$(printf 'no\\033[2Jfile')\"");
  EXPECT_EQ(run.err.find('\x1b'), std::string::npos) << to_string(run);
  EXPECT_NE(run.err.find("\\x1b"), std::string::npos) << run.err;
}

TEST_F(Surroundings, JsonThatIsNestedTooDeeplyIsAnErrorWhereverItIsRead) {
  const std::string deep(100'000, '[');
  auto& work = shell->work();
  work.write("deep/bundle.json", "{\"provenance\":" + deep);
  work.write("deep/trials.csv", "trial_id,success,time_s\n");
  work.write("deep.json", deep);
  work.write("deep.jsonl", "{\"a\":" + deep + "}\n{\"a\":" + deep + "}\n");
  work.write("tree/one/manifest.json", deep);
  work.write("file.csv.manifest.json", deep);
  work.write("file.csv", "");
  for (const char* line : {"$T check deep",
                           "$T certify deep",
                           "$T live --bundle deep < ticks.csv",
                           "$T world deep.json",
                           "$T world deep.jsonl",
                           "$T verify tree",
                           "$T verify file.csv",
                           "$T figures tree --output drawn"}) {
    const ProcessResult run = shell->run(line);
    EXPECT_TRUE(run.exit_code == 65 || run.exit_code == 66) << to_string(run);
    EXPECT_NE(run.err.find("nested too deeply"), std::string::npos) << to_string(run);
  }
  work.write("deep_ticks.jsonl", "{\"time_s\":" + deep + "\n");
  EXPECT_EQ(shell->run("$T live --bundle corpus < deep_ticks.jsonl").exit_code, 3);
}

TEST_F(Surroundings, AnObjectOfVeryManyKeysIsAnErrorAtOnce) {
  std::string wide = "{";
  for (int i = 0; i < 200'000; ++i) {
    wide += "\"k" + std::to_string(i) + "\":1,";
  }
  auto& work = shell->work();
  const auto widened = [&](const std::string& name) { return wide + work.read(name).substr(1); };
  work.write("wide/one/manifest.json", widened("made/manifest.json"));
  work.write("wide.json", widened("corpus/worlds/t0000000.json"));
  work.write("wide/bundle.json", widened("corpus/bundle.json"));
  work.write("wide/trials.csv", "trial_id,success,time_s\n");
  for (const char* line :
       {"verify wide", "figures wide --output drawn", "world wide.json", "check wide"}) {
    const ProcessResult run = shell->run(std::string("timeout 10 $T ") + line);
    EXPECT_TRUE(run.exit_code == 65 || run.exit_code == 66) << to_string(run);
    EXPECT_NE(run.err.find("more than 4096 keys"), std::string::npos) << to_string(run);
  }
}

TEST_F(Surroundings, AFileMadeToFillTheMemoryIsRefused) {
  const ProcessResult run = shell->run(
      "cp -r corpus bomb && (echo time_s,x_m,y_m,yaw_rad; head -c 300000000 /dev/zero) | gzip -9 > "
      "bomb/logs/t0000001/pose.csv.gz && rm bomb/logs/t0000001/pose.csv; "
      "(ulimit -v 4000000; $T certify bomb --threads 1 --output bombed)");
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  EXPECT_NE(run.err.find("200 times as long"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("rejected: t0000001"), std::string::npos) << run.err;
}

TEST_F(Surroundings, ALogThatWouldBeTooManyTicksIsRejected) {
  std::string pose = "time_s,x_m,y_m,yaw_rad\n";
  std::string tactile = shell->work().read("corpus/logs/t0000001/tactile.csv");
  const auto header_end = tactile.find('\n', tactile.find('\n') + 1);
  const auto row_end = tactile.find('\n', header_end + 1);
  const std::string row = tactile.substr(header_end + 1, row_end - header_end - 1);
  tactile.resize(header_end + 1);
  for (int k = 0; k < 400; ++k) {
    const std::string time = std::to_string(50 * k);
    pose += time + ",0,0,0\n";
    tactile += time + row.substr(row.find(',')) + "\n";
  }
  shell->work().write("pose.csv", pose);
  shell->work().write("tactile.csv", tactile);
  const ProcessResult run = shell->run(
      "cp -r corpus slow && rm -r slow/logs/t0000001/* && cp pose.csv tactile.csv "
      "slow/logs/t0000001/; $T certify slow --set tick_s=0.001 --format csv");
  EXPECT_EQ(run.exit_code, 3) << to_string(run);
  EXPECT_NE(run.err.find("raise tick_s"), std::string::npos) << run.err;
}

TEST_F(Surroundings, AnAuditLogStaysUntilTheNextRunStands) {
  ASSERT_EQ(shell->run("$T live --bundle corpus --audit kept.csv < ticks.csv > rows.csv").exit_code,
            0);
  const std::string log = shell->work().read("kept.csv");
  ASSERT_FALSE(log.empty());
  for (const char* const fails : {"--record corpus < ticks.csv",
                                  "--listen unix:/nonexistent/socket < ticks.csv",
                                  "< /dev/null"}) {
    static_cast<void>(
        shell->run(std::string("$T live --bundle corpus --audit kept.csv > rows2.csv ") + fails));
    EXPECT_EQ(shell->work().read("kept.csv"), log) << fails;
  }
  const ProcessResult second = shell->run(
      "mkfifo ticks.fifo; ($T live --bundle corpus --audit kept.csv < ticks.fifo > rows3.csv &) ; "
      "exec 9> ticks.fifo; sleep 1; $T live --bundle corpus --audit kept.csv < ticks.csv; "
      "code=$?; exec 9>&-; sleep 1; exit $code");
  EXPECT_EQ(second.exit_code, 73) << to_string(second);
  EXPECT_NE(second.err.find("another run writes it"), std::string::npos) << second.err;
}

TEST_F(Surroundings, ReproduceThatCannotRunRemovesNothing) {
  ASSERT_EQ(shell
                ->run("mkdir study && $T simulate --trials 3 --output study/corpus && "
                      "$T simulate --micro-study --output study/gates")
                .exit_code,
            0);
  const auto before = shell->contents("study");
  EXPECT_EQ(shell->run("$T reproduce typo --output study").exit_code, 66);
  EXPECT_EQ(shell->run("$T reproduce corpus --output study --set body_width_m=-1").exit_code, 2);
  EXPECT_EQ(shell->contents("study"), before);
  ASSERT_EQ(shell->run("echo mine > study/report.html").exit_code, 0);
  EXPECT_EQ(shell->run("$T reproduce corpus --output study").exit_code, 73);
  ASSERT_EQ(shell->run("rm study/report.html").exit_code, 0);
  EXPECT_EQ(shell->contents("study"), before);
}

TEST_F(Surroundings, VerifyOnAMachineThatIsShortKnowsNothing) {
  const ProcessResult run = shell->run("ulimit -f 40; $T verify made --inputs corpus");
  EXPECT_NE(run.exit_code, 0) << to_string(run);
  EXPECT_NE(run.exit_code, 1) << "no difference was seen: " << to_string(run);
}

}  // namespace
}  // namespace tcert
