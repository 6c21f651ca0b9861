#include <gtest/gtest.h>

#include <string>

#include "support/workdir.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::to_string;
using test_support::Workdir;

void expect_refused(const ProcessResult& run, std::string_view suggestion) {
  EXPECT_EQ(run.exit_code, 2) << to_string(run);
  EXPECT_EQ(run.out, "") << to_string(run);
  EXPECT_NE(run.err.find(suggestion), std::string::npos) << to_string(run);
}

TEST(Usage, EveryCommandHasHelpWithAnExample) {
  Workdir work(TCERT_BINARY);
  for (const char* command : {"simulate",
                              "import",
                              "check",
                              "certify",
                              "world",
                              "fit",
                              "hypotheses",
                              "reproduce",
                              "live"}) {
    const ProcessResult run = work.run({command, "--help"});
    EXPECT_EQ(run.exit_code, 0) << to_string(run);
    EXPECT_NE(run.out.find("Example:\n  "), std::string::npos) << to_string(run);
    EXPECT_NE(run.out.find("Cost: "), std::string::npos) << to_string(run);
    EXPECT_EQ(work.run({"help", command}).out, run.out);
    EXPECT_NE(work.run({"help"}).out.find(command), std::string::npos);
  }
}

TEST(Usage, SuggestsTheNearestName) {
  Workdir work(TCERT_BINARY);
  expect_refused(work.run({"certfy", "bundle"}), "did you mean 'certify'?");
  expect_refused(work.run({"certify", "bundle", "--outptu", "x"}), "did you mean '--output'?");
  expect_refused(work.run({"simulate", "--output", "x", "--set", "edge_lenght_m=1"}), "--set");
}

TEST(Usage, RefusesValuesOutOfRange) {
  Workdir work(TCERT_BINARY);
  expect_refused(work.run({"simulate", "--output", "x", "--trials", "-1"}), "trials");
  expect_refused(work.run({"simulate", "--output", "x", "--seed", "abc"}), "seed");
  expect_refused(work.run({"simulate"}), "--output");
  ASSERT_EQ(work.run({"simulate", "--output", "corpus", "--trials", "1", "--quiet"}).exit_code, 0);
  expect_refused(work.run({"certify", "corpus", "--set", "edge_lenght_m=1"}),
                 "did you mean 'edge_length_m'?");
  expect_refused(work.run({"certify", "corpus", "--set", "edge_length_m=0"}), "edge_length_m");
  expect_refused(work.run({"certify", "corpus", "--set", "curvature=paht"}), "path");
  expect_refused(work.run({"certify", "corpus", "--trials", "nobody"}), "nobody");
}

TEST(Usage, NamesWhatIsNotThereOrCannotBeWritten) {
  Workdir work(TCERT_BINARY);
  EXPECT_EQ(work.run({"certify", "nowhere"}).exit_code, 66);
  EXPECT_EQ(work.run({"check", "nowhere.csv"}).exit_code, 66);
  work.write("broken/bundle.json", "{\"format\": \"tcert-bundle\",");
  EXPECT_EQ(work.run({"certify", "broken"}).exit_code, 65);
  work.write("taken/note.txt", "not ours");
  const ProcessResult run = work.run({"simulate", "--trials", "1", "--output", "taken"});
  EXPECT_EQ(run.exit_code, 73) << to_string(run);
  EXPECT_EQ(work.read("taken/note.txt"), "not ours");
  EXPECT_EQ(work.run({"simulate", "--trials", "1", "--output", "taken/note.txt/x"}).exit_code, 73);
}

TEST(Usage, NeverReplacesItsOwnInput) {
  Workdir work(TCERT_BINARY);
  ASSERT_EQ(work.run({"simulate", "--output", "all/corpus", "--trials", "1"}).exit_code, 0);
  for (const char* output : {"all/corpus", "all/../all/corpus/", "all"}) {
    expect_refused(work.run({"certify", "all/corpus", "--output", output}), "replace the input");
  }
  EXPECT_EQ(work.run({"certify", "all/corpus", "--output", "all/results"}).exit_code, 0);
}

}  // namespace
}  // namespace tcert
