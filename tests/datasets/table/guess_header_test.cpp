#include <gtest/gtest.h>

#include <string>
#include <table/csv_header.hpp>
#include <vector>

namespace tcert::table {
namespace {

struct Guessed {
  std::vector<std::string> names;
  std::size_t line = 0;
  std::string first_data;
  std::vector<Diagnostic> problems;
};

Guessed guess(const std::string& text, const CsvOptions& options = {}) {
  DiagnosticGroups problems;
  const auto header = guess_header(text, options, problems);
  Guessed guessed;
  if (header) {
    guessed.names = header->names;
    guessed.line = header->line;
    std::string rest(header->data.at, header->data.end);
    guessed.first_data = rest.substr(0, rest.find('\n'));
  }
  guessed.problems = problems.take();
  return guessed;
}

using Names = std::vector<std::string>;

TEST(GuessHeader, TakesTextOverNumbers) {
  const Guessed found = guess("time_s,x\n0,1\n1,2\n");
  EXPECT_EQ(found.names, (Names{"time_s", "x"}));
  EXPECT_EQ(found.line, 1U);
  EXPECT_TRUE(found.problems.empty());
}

TEST(GuessHeader, KeepsTheFirstRowOfAFileWithoutHeader) {
  const Guessed found = guess("run1,0.5,1\nrun2,0.6,0\nrun3,0.7,1\n");
  EXPECT_EQ(found.names, (Names{"c1", "c2", "c3"}));
  EXPECT_EQ(found.line, 0U);
  EXPECT_EQ(found.first_data, "run1,0.5,1");
}

TEST(GuessHeader, TakesColumnsThatAreNumberedForOne) {
  EXPECT_EQ(guess("time,0,1,2\n0.1,5,6,7\n0.2,6,7,8\n").names, (Names{"time", "0", "1", "2"}));
}

TEST(GuessHeader, AllowsEmptyFieldsBeyondTheHeader) {
  const Guessed found = guess("time_s,x\n0,1,\n0.1,2,\n0.2,3,\n");
  EXPECT_EQ(found.names, (Names{"time_s", "x"}));
  EXPECT_TRUE(found.problems.empty());
}

TEST(GuessHeader, DropsAnEmptyLastNameOverNothing) {
  EXPECT_EQ(guess("time_s,x,\n0,1,\n0.1,2,\n").names, (Names{"time_s", "x"}));
}

TEST(GuessHeader, RefusesAHeaderOfAnotherLengthThanTheRows) {
  const Guessed found = guess(
      "Time,seq,frame,x,y,z,w,u,v\n1464818234.3,39500,/odom,0.1,0,0.5,1\n"
      "1464818234.4,39501,/odom,0.2,0,0.5,1\n1464818234.5,39502,/odom,0.3,0,0.5,1\n");
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].severity, Severity::error);
  EXPECT_EQ(found.problems[0].line, 1U);
  EXPECT_EQ(found.problems[0].value, "a header of 9 names, rows of 7 fields");
}

TEST(GuessHeader, TakesLinesBeforeItAsANote) {
  const Guessed found = guess("Robot log\nfirmware 3\ntime_s,x\n0,1\n1,2\n2,3\n");
  EXPECT_EQ(found.names, (Names{"time_s", "x"}));
  ASSERT_EQ(found.problems.size(), 1U);
  EXPECT_EQ(found.problems[0].severity, Severity::note);
}

TEST(GuessHeader, TakesNamesOutOfACommentRightBeforeTheRows) {
  const Guessed euroc = guess(
      "#timestamp, p_x [m], p_y [m]\n1403715524907143168,0.5,1.9\n"
      "1403715524912143104,0.6,1.9\n");
  EXPECT_EQ(euroc.names, (Names{"timestamp", "p_x [m]", "p_y [m]"}));
  const Guessed tum = guess("# ground truth\n# timestamp tx ty\n1.5 0.1 0.2\n1.6 0.1 0.2\n");
  EXPECT_EQ(tum.names, (Names{"timestamp", "tx", "ty"}));
  const Guessed other = guess("# written by a robot on Monday\n1.5 0.1 0.2\n1.6 0.1 0.2\n");
  EXPECT_EQ(other.names, (Names{"c1", "c2", "c3"}));
}

TEST(GuessHeader, SeparatesByVerticalBarsAndWithDecimalCommas) {
  EXPECT_EQ(guess("time_s|x_m\n0|1\n0.1|2\n").names, (Names{"time_s", "x_m"}));
  CsvOptions commas;
  commas.decimal_comma = true;
  EXPECT_EQ(guess("time_s\tx_m\n0,0\t1,5\n0,1\t2,5\n", commas).names, (Names{"time_s", "x_m"}));
}

TEST(GuessHeader, TakesTheFirstLineOfATableOfNames) {
  EXPECT_EQ(guess("robot,room\nr1,dark\nr2,dim\n").names, (Names{"robot", "room"}));
}

}  // namespace
}  // namespace tcert::table
