// CSV files that begin with a '#' line are read by others as the help says.

#include <gtest/gtest.h>

#include <string>

#include "support/shell.hpp"

namespace tcert {
namespace {

using test_support::ProcessResult;
using test_support::Shell;
using test_support::to_string;

constexpr const char* kPython = R"py(
import csv, sys
try:
    import pandas
except ImportError:
    pandas = None
for name in sys.argv[1:]:
    lines = open(name, newline='').read().splitlines()
    assert lines[0].startswith('# ') and 'synthetic' in lines[0].lower(), name
    assert not any(line.startswith('#') for line in lines[1:]), name
    rows = list(csv.DictReader(line for line in lines if not line.startswith('#')))
    assert len(rows) == len(lines) - 2 and float(rows[0]['time_s']) >= 0, name
    if pandas:
        table = pandas.read_csv(name, comment='#')
        assert list(table.columns) == list(rows[0]) and len(table) == len(rows), name
print('read', len(sys.argv) - 1)
)py";

class CommentLine : public ::testing::Test {
 protected:
  void SetUp() override {
    const ProcessResult made = shell_.run(
        "$T simulate --trials 1 --output corpus --quiet && $T certify corpus --ticks --output r "
        "--quiet");
    ASSERT_EQ(made.exit_code, 0) << to_string(made);
  }

  bool has(const std::string& program) {
    return shell_.run("command -v " + program).exit_code == 0;
  }

  Shell shell_;
  static constexpr const char* kFiles =
      " corpus/trials.csv corpus/logs/t0000000/pose.csv corpus/logs/t0000000/tactile.csv "
      "corpus/logs/t0000000/control.csv r/ticks/t0000000.csv";
};

TEST_F(CommentLine, IsReadByPython) {
  if (!has("python3")) {
    GTEST_SKIP() << "python3 is not installed";
  }
  shell_.work().write("read.py", kPython);
  const ProcessResult run = shell_.run(std::string("python3 read.py") + kFiles);
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
  EXPECT_EQ(run.out, "read 5\n");
}

TEST_F(CommentLine, IsReadByR) {
  if (!has("Rscript")) {
    GTEST_SKIP() << "R is not installed";
  }
  const ProcessResult run =
      shell_.run(std::string("for f in") + kFiles +
                 "; do Rscript -e 'd <- read.csv(commandArgs(TRUE), comment.char = \"#\"); "
                 "stopifnot(nrow(d) > 0, is.numeric(d$time_s))' $f || exit 1; done");
  EXPECT_EQ(run.exit_code, 0) << to_string(run);
}

TEST_F(CommentLine, IsInTheHelpOfWhatWritesIt) {
  for (const char* const command : {"simulate", "certify"}) {
    const ProcessResult run = shell_.run(std::string("$T help ") + command);
    EXPECT_NE(run.out.find("comment='#'"), std::string::npos) << command;
    EXPECT_NE(run.out.find("comment.char = '#'"), std::string::npos) << command;
  }
}

}  // namespace
}  // namespace tcert
