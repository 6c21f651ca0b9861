#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "support/shell.hpp"

namespace tcert {
namespace {

using nlohmann::json;
using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

constexpr const char* kAllKinds =
    " --dropout-good-s 20 --bursts-per-hour 120 --spikes-per-hour 120 --freezes-per-hour 120"
    " --wide-per-hour 120 --biases-per-hour 120 ";

class Perturb : public ::testing::Test {
 protected:
  Perturb() { expect(0, "$T simulate --trials 4 --output corpus"); }

  ProcessResult expect(int exit_code, const std::string& line) {
    ProcessResult run = shell_.run(line);
    EXPECT_EQ(run.exit_code, exit_code) << line << '\n' << to_string(run);
    return run;
  }

  Shell shell_;
};

TEST_F(Perturb, WithoutAFaultTheBundleIsWhatItWas) {
  expect(0, "$T assure perturb corpus --output same");
  expect(0, "diff -r --exclude=manifest.json corpus same && ! test -e same/injections.csv");
  expect(0, "$T verify same --inputs .");
  // A rate at which nothing happens leaves the logs alone too.
  expect(0, "$T assure perturb corpus --spikes-per-hour 0.000001 --output rare");
  expect(0, "diff -r --exclude=manifest.json --exclude=injections.csv corpus rare");
  expect(0, "test $(grep -vc '^#' rare/injections.csv) = 1");
}

TEST_F(Perturb, GivesTheSameBytesForAnyThreadsAndWhateverElseIsInTheBundle) {
  expect(0, std::string("$T assure perturb corpus --seed 5 --threads 1 --output one") + kAllKinds);
  expect(0, std::string("$T assure perturb corpus --seed 5 --threads 2 --output two") + kAllKinds);
  expect(0, "diff -r one two");
  expect(0, "$T verify one --inputs .");
  expect(0, std::string("$T assure perturb corpus --seed 6 --output other") + kAllKinds);
  expect(1, "cmp -s one/injections.csv other/injections.csv");
  // One trial alone has the same faults.
  expect(0,
         "mkdir alone && cp -r corpus/bundle.json corpus/worlds corpus/logs alone && "
         "head -2 corpus/trials.csv > alone/trials.csv && tail -1 corpus/trials.csv >> "
         "alone/trials.csv");
  expect(0, std::string("$T assure perturb alone --seed 5 --output lone") + kAllKinds);
  expect(
      0,
      "id=$(tail -1 corpus/trials.csv | cut -d, -f1) && grep \"^$id,\" one/injections.csv > a && "
      "grep -v '^#\\|^trial_id' lone/injections.csv > b && test -s a && cmp a b && "
      "diff -r one/logs/$id lone/logs/$id");
  // Kinds do not change each other's draws.
  expect(0, "$T assure perturb corpus --seed 5 --wide-per-hour 120 --output wide");
  expect(0,
         "grep ,wide, one/injections.csv | cut -d, -f1-6 > a; grep ,wide, wide/injections.csv | "
         "cut -d, -f1-6 > b; test -s b; grep -vxFf a b | wc -l | grep -qx 0");
}

TEST_F(Perturb, ListsWhatItDidAndLeavesWhatNoFaultMet) {
  const ProcessResult run = expect(
      0, "$T assure perturb corpus --wide-per-hour 200 --spikes-per-hour 200 --output stuck");
  EXPECT_NE(run.err.find("wide: "), std::string::npos) << run.err;
  expect(0,
         "head -1 stuck/injections.csv | grep -q SYNTHETIC || head -1 stuck/injections.csv | grep "
         "-q synthetic");
  expect(
      0,
      "test $(sed -n 2p stuck/injections.csv) = trial_id,kind,stream,ray,start_s,end_s,size,unit");
  // Columns: faults of rays name one, end in their trial, and are in tactile.csv.
  expect(0,
         "grep -v '^#\\|^trial_id' stuck/injections.csv | awk -F, '$3 != \"tactile.csv\" || $4 == "
         "\"\" || "
         "$6 <= $5 || ($2 == \"spike\" && ($7 != 10 || $8 != \"N\")) { exit 1 }'");
  expect(0,
         "diff -r corpus/worlds stuck/worlds && cmp corpus/trials.csv stuck/trials.csv && "
         "cmp corpus/bundle.json stuck/bundle.json");
  expect(0,
         "for t in corpus/logs/*; do cmp $t/pose.csv stuck/logs/${t##*/}/pose.csv || exit 1; done");
  expect(0, "$T check stuck");
  expect(0, "$T certify stuck --output results");
  // Perturbed again it keeps the list of what was done before.
  expect(0, "$T assure perturb stuck --dropout-good-s 10 --output twice");
  expect(0,
         "n=$(wc -c < stuck/injections.csv) && head -c $n twice/injections.csv | cmp - "
         "stuck/injections.csv "
         "&& grep -q dropout twice/injections.csv");
}

TEST_F(Perturb, ReadsAnArchiveAndPackedStreams) {
  expect(0,
         "gzip -n corpus/logs/*/tactile.csv && $T assure perturb corpus --output packed "
         "--wide-per-hour 400");
  expect(0, "! test -e packed/logs/$(ls corpus/logs | head -1)/tactile.csv.gz && $T check packed");
  if (expect(0, "command -v zip > /dev/null; echo $?").out == "0\n") {
    expect(0, "cd corpus && zip -qr ../corpus.zip . && cd ..");
    expect(0, "$T assure perturb corpus.zip --output unpacked");
    expect(0, "diff -r --exclude=manifest.json corpus unpacked");
  }
}

TEST_F(Perturb, RefusesWhatItCannotDo) {
  expect(2, "$T assure perturb corpus");
  expect(2, "$T assure perturb corpus --output corpus");
  expect(2, "$T assure perturb corpus --output x --streams pose,wheels --dropout-good-s 9");
  expect(2, "$T assure perturb corpus --output x --dropout-good-s 0.1");
  expect(2, "$T assure perturb corpus --output x --spikes-per-hour -1");
  expect(2, "$T assure perturb corpus --output x --wide-share 1.5");
  expect(2, "$T assure disturb corpus --output x");
  expect(66, "$T assure perturb nothing --output x");
  // A trial whose log is rejected is copied and named.
  expect(3,
         "id=$(ls corpus/logs | head -1) && rm corpus/logs/$id/pose.csv && "
         "$T assure perturb corpus --output x --wide-per-hour 400");
  expect(0, "id=$(ls corpus/logs | head -1) && diff -r corpus/logs/$id x/logs/$id");
}

}  // namespace
}  // namespace tcert
