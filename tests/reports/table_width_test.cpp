#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "reports/findings.hpp"
#include "reports/table.hpp"
#include "reports/text_width.hpp"

namespace tcert {
namespace {

std::size_t widest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t widest = 0;
  for (std::string line; std::getline(lines, line);) {
    widest = std::max(widest, width_of(line));
  }
  return widest;
}

Table wide_table() {
  Table table;
  table.title = "Wide";
  table.columns = {{"cell", "cell", "", ColumnKind::text},
                   {"first", "gain of the first kind", "m", ColumnKind::number, 2},
                   {"second", "gain of the second kind", "m", ColumnKind::number, 2},
                   {"third", "gain of the third kind", "m", ColumnKind::number, 2}};
  table.add_row({std::string("a"), Number{1.0}, Number{2.0}, Number{3.0}});
  table.footnotes = {"A note of many words, which is as long as the table is wide and longer."};
  return table;
}

TEST(TableWidth, BreaksHeadingsBeforeItLeavesColumnsOut) {
  const std::string text = render(wide_table(), TableFormat::text, 40);
  EXPECT_LE(widest_line(text), 40U) << text;
  EXPECT_NE(text.find("3.00"), std::string::npos) << "all columns are there\n" << text;
  EXPECT_EQ(text.find("Not shown"), std::string::npos) << text;
}

TEST(TableWidth, NamesTheColumnsThatDoNotFit) {
  const std::string text = render(wide_table(), TableFormat::text, 20);
  EXPECT_EQ(text.find("3.00"), std::string::npos) << text;
  EXPECT_NE(wrapped(text, 0).find("--wide"), std::string::npos) << text;
  EXPECT_NE(text.find("third"), std::string::npos) << "its heading is named\n" << text;
}

// Though all rows say the same, and though it stands on the right.
TEST(TableWidth, KeepsTheColumnThatTheTableIsFor) {
  Table table = wide_table();
  table.add_row({std::string("b"), Number{1.5}, Number{2.5}, Number{3.0}});
  table.columns[3].is_answer = true;
  const std::string text = render(table, TableFormat::text, 20);
  EXPECT_NE(text.find("3.00"), std::string::npos) << text;
  EXPECT_EQ(text.find("2.50"), std::string::npos) << text;
}

TEST(TableWidth, LeavesEveryOtherFormatAndAWideTerminalAlone) {
  const Table table = wide_table();
  for (const TableFormat format : {TableFormat::markdown,
                                   TableFormat::csv,
                                   TableFormat::json,
                                   TableFormat::jsonl,
                                   TableFormat::latex}) {
    EXPECT_EQ(render(table, format, 20), render(table, format));
  }
  EXPECT_EQ(render(table, TableFormat::text, 200), render(table, TableFormat::text));
}

TEST(TableWidth, BreaksALongTextInsteadOfLeavingItOut) {
  Table table;
  table.columns = {{"trial", "trial", "", ColumnKind::text},
                   {"found", "found", "", ColumnKind::text},
                   {"count", "count", "", ColumnKind::integer}};
  table.add_row({std::string("t1"),
                 std::string("a sentence of a dozen words that no terminal of forty has room for"),
                 std::int64_t{7}});
  const std::string text = render(table, TableFormat::text, 40);
  EXPECT_LE(widest_line(text), 40U) << text;
  EXPECT_NE(text.find("room for"), std::string::npos) << text;
  EXPECT_NE(text.find("7"), std::string::npos) << text;
}

TEST(TableWidth, LeavesOutWhatIsTheSameInEveryRowFirst) {
  Table table = wide_table();
  table.rows.clear();
  table.add_row({std::string("a"), Number{1.0}, Number{2.0}, Number{3.0}});
  table.add_row({std::string("b"), Number{1.0}, Number{4.0}, Number{5.0}});
  const std::string text = render(table, TableFormat::text, 20);
  EXPECT_EQ(text.find("1.00"), std::string::npos) << text;
  EXPECT_NE(text.find("5.00"), std::string::npos) << text;
}

TEST(TextWidth, BreaksAtSpacesAndIndentsWhatGoesOn) {
  EXPECT_EQ(wrapped("one two three\nfour\n", 8), "one\n  two\n  three\nfour\n");
  EXPECT_EQ(wrapped("one two three\n", 0), "one two three\n");
  EXPECT_EQ(wrapped("", 8), "");
  EXPECT_EQ(width_of("\xC3\xA4\xC3\xB6"), 2U) << "characters, not bytes";
  const std::vector<std::string> lines{"unbreakable", "word"};
  EXPECT_EQ(broken("unbreakable word", 4), lines);
}

TEST(Findings, AreSentencesWithTheVerdictAndTheRulesBelow) {
  const Table table = findings_table({{"H1, success", "supported", "AUC 0.9."}, {"Seen", "", "2."}},
                                     {"Rule: an interval."});
  EXPECT_EQ(findings_text(table),
            "H1, success: supported. AUC 0.9.\nSeen: 2.\nRule: an interval.\n");
  EXPECT_EQ(findings_text(Table{}), "");
  EXPECT_EQ(in_words(0.5, {}), "0.500");
  EXPECT_EQ(in_words({}, {}), "NA");
  EXPECT_EQ(in_words(0.5, statistics::Interval{0.25, 0.75}, 2), "0.50 [0.25, 0.75]");
  EXPECT_EQ(in_words(0.5, statistics::Interval{0.0004, 0.75}), "0.5000 [0.0004, 0.7500]")
      << "a bound above 0 does not read as 0";
  EXPECT_EQ(in_words(0.5, statistics::Interval{0.0, 0.75}), "0.500 [0.000, 0.750]");
  const Table again = table_from_json(render(table, TableFormat::json));
  EXPECT_EQ(findings_text(again), findings_text(table))
      << "what 'reproduce' reads is what was said";
}

}  // namespace
}  // namespace tcert
