#include <table/printable.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tcert::table {
namespace {

TEST(Printable, LetsNothingSteerTheTerminal) {
  EXPECT_EQ(printable("caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80"),
            "caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x98\x80");
  EXPECT_EQ(printable("\xFF\xFE\x80"), "\\xff\\xfe\\x80");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "\\xc2\\x9b"
            "2J")
      << "C1: the eight-bit escape";
  EXPECT_EQ(printable("a\xE2\x80\xAE"
                      "b"),
            "a\\xe2\\x80\\xae"
            "b")
      << "right to left";
  EXPECT_EQ(printable("\xC0\xAF\xED\xA0\x80"), "\\xc0\\xaf\\xed\\xa0\\x80")
      << "overlong, surrogate";
  EXPECT_EQ(printable("\xE2\x82"), "\\xe2\\x82") << "cut";
  EXPECT_EQ(printable("\xE2\x80\x8F\xD8\x9C"), "\\xe2\\x80\\x8f\\xd8\\x9c") << "marks of direction";
}

TEST(Printable, KeepsLinesAndTabsOfAWholeText) {
  EXPECT_EQ(printable_lines("a\tb\n\x1b[2J\r\n"), "a\tb\n\\x1b[2J\\r\n");
  EXPECT_EQ(printable_lines(""), "");
}

}  // namespace
}  // namespace tcert::table
