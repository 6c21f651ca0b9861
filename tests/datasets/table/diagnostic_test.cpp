#include <table/diagnostic.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tcert::table {
namespace {

TEST(Diagnostic, PrintsFileLineColumnValueExpectationAndCount) {
  const Diagnostic diagnostic{Severity::error, "logs/t1/pose.csv", 7, "x_m", "abc", "a number", 4};
  EXPECT_EQ(to_string(diagnostic),
            "logs/t1/pose.csv:7: error: column 'x_m': found 'abc', expected a number (and 3 more)");
}

TEST(Diagnostic, LeavesOutWhatItDoesNotHave) {
  EXPECT_EQ(to_string({Severity::warning, "a.csv", 0, "", "", "at least one row", 1}),
            "a.csv: warning: expected at least one row");
}

TEST(Diagnostic, GroupsTheSameProblemOfOneColumnOnly) {
  DiagnosticGroups groups;
  groups.add({Severity::error, "a.csv", 2, "x", "p", "a number", 1});
  groups.add({Severity::error, "a.csv", 3, "y", "q", "a number", 1});
  groups.add({Severity::error, "a.csv", 4, "x", "r", "a number", 1});
  const std::vector<Diagnostic> all = groups.take();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].line, 2U);
  EXPECT_EQ(all[0].value, "p");
  EXPECT_EQ(all[0].count, 2U);
  EXPECT_EQ(all[1].count, 1U);
  EXPECT_TRUE(groups.take().empty());
}

TEST(Diagnostic, OnlyErrorsReject) {
  DiagnosticGroups groups;
  groups.add({Severity::warning, "a.csv", 0, "", "", "x", 1});
  EXPECT_FALSE(groups.has_error());
  groups.add({Severity::error, "a.csv", 0, "", "", "x", 1});
  EXPECT_TRUE(groups.has_error());
}

TEST(Shortened, EscapesControlCharactersAndCutsBetweenCharacters) {
  EXPECT_EQ(shortened("a\tb\n\x1b[2J"), "a\\tb\\n\\x1b[2J");
  EXPECT_EQ(shortened(std::string(41, 'x')), std::string(40, 'x') + "...");
  EXPECT_EQ(shortened(std::string(39, 'x') + "\xC3\xA9"), std::string(39, 'x') + "...");
}

}  // namespace
}  // namespace tcert::table
