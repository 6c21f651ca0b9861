/// The scratch folder of `verify`: gone however the command ends.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "support/shell.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;

class Scratch : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    shell = std::make_unique<Shell>();
    const ProcessResult run = shell->run(
        "mkdir tmp && $T simulate --trials 6 --output tree/corpus && "
        "$T certify tree/corpus --output tree/certificates");
    ASSERT_EQ(run.exit_code, 0) << to_string(run);
  }
  static void TearDownTestSuite() { shell.reset(); }

  /// Verifies the tree, stops before call `call` that brings something to the disk, and sends the
  /// signals. Prints the exit code and what then lies in the folder for temporary files.
  static ProcessResult ended_by(const std::string& signals, int call) {
    return shell->run(
        "export TMPDIR=$PWD/tmp; LD_PRELOAD='" TCERT_KILL_AT_LIBRARY "' TCERT_STOP_AT=" +
        std::to_string(call) +
        " $T verify tree --quiet & pid=$!; "
        "until grep -q '^State:.T' /proc/$pid/status; do sleep 0.01; done; ls -A tmp | wc -l; " +
        signals + "; wait $pid; echo $?; ls -A tmp | sed 's/[0-9][0-9]*/N/g'");
  }

  static std::unique_ptr<Shell> shell;
};

std::unique_ptr<Shell> Scratch::shell;

TEST_F(Scratch, IsRemovedByASignal) {
  for (int call = 1; call <= 2; ++call) {
    const ProcessResult term = ended_by("kill -TERM $pid; kill -CONT $pid", call);
    EXPECT_EQ(term.out, "1\n143\n") << to_string(term);
    const ProcessResult hang_up = ended_by("kill -HUP $pid; kill -CONT $pid", call);
    EXPECT_EQ(hang_up.out, "1\n129\n") << to_string(hang_up);
  }
}

/// At any time, also while hundreds of files are written into it.
TEST_F(Scratch, IsNotBroughtBackByWhoStillWritesIntoIt) {
  const ProcessResult run = shell->run(
      "export TMPDIR=$PWD/tmp; for k in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do "
      "$T verify tree --quiet > words.txt 2>&1 & pid=$!; "
      "until [ -n \"$(ls -A tmp)\" ] || ! kill -0 $pid 2> /dev/null; do :; done; "
      "kill -TERM $pid 2> /dev/null; wait $pid; ls -A tmp; done");
  EXPECT_EQ(run.out, "") << to_string(run);
}

TEST_F(Scratch, OfAKilledProcessIsSweptByTheNext) {
  const ProcessResult killed = ended_by("kill -KILL $pid", 1);
  EXPECT_EQ(killed.out, "1\n137\n.tcert.N-N.tmp\n") << to_string(killed);
  const ProcessResult next = shell->run("TMPDIR=$PWD/tmp $T verify tree --quiet; ls -A tmp");
  EXPECT_EQ(next.exit_code, 0) << to_string(next);
  EXPECT_EQ(next.out.find(".tmp"), std::string::npos) << to_string(next);
}

}  // namespace
}  // namespace tcert
