#include <table/path_name.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tcert::table {
namespace {

TEST(FileName, IsOneStepThatIsNeitherHiddenNorTooLong) {
  for (const char* name : {"t0000001", "a b", "d\xC3\xBCne", "a.b", "-x", "CON", "\xFF\xFE"}) {
    EXPECT_TRUE(is_file_name(name)) << name;
  }
  EXPECT_TRUE(is_file_name(std::string(230, 'a')));
  for (const std::string& name : {std::string(),
                                  std::string("."),
                                  std::string(".."),
                                  std::string(".hidden"),
                                  std::string("a/b"),
                                  std::string("/etc"),
                                  std::string("a\\b"),
                                  std::string("a\nb"),
                                  std::string("a\tb"),
                                  std::string("\x1b[31m"),
                                  std::string("a\x7F"),
                                  std::string("a\0b", 3),
                                  std::string(231, 'a')}) {
    EXPECT_FALSE(is_file_name(name)) << name;
    EXPECT_TRUE(is_file_name(as_file_name(name))) << as_file_name(name);
  }
}

TEST(FileName, OfSomethingElseIsCutBetweenCharacters) {
  const std::string longer = std::string(229, 'a') + "\xC3\xBC";
  EXPECT_EQ(as_file_name(longer), std::string(229, 'a'));
  EXPECT_EQ(as_file_name("a/b"), "a_b");
  EXPECT_EQ(as_file_name(".."), "_.");
  EXPECT_EQ(as_file_name("gate 3"), "gate 3");
}

TEST(PathStep, IsWhatSomebodyElseMayHaveMadeInAFolder) {
  for (const char* name : {".hidden", "a\nb", "...", "a\\b"}) {
    EXPECT_TRUE(is_path_step(name)) << name;
  }
  for (const char* name : {"", ".", "..", "a/b", "/"}) {
    EXPECT_FALSE(is_path_step(name)) << name;
  }
}

TEST(LeadsBelow, RefusesWhatLeadsOutOrNowhere) {
  EXPECT_TRUE(leads_below("a"));
  EXPECT_TRUE(leads_below("a/b.csv"));
  for (const char* path : {"", "/a", "..", "../a", "a/../../b", "a/..", "a/.", "a//../b", "a/"}) {
    EXPECT_FALSE(leads_below(path)) << path;
  }
}

TEST(TemporaryNames, AreHiddenAndEndInTmp) {
  EXPECT_TRUE(is_temporary_name(".results.123-0.tmp"));
  EXPECT_TRUE(is_temporary_name(".run.123-0.kept.tmp"));
  EXPECT_FALSE(is_temporary_name("results.123-0.tmp"));
  EXPECT_FALSE(is_temporary_name(".results"));
  EXPECT_FALSE(is_temporary_name(".tmp"));
}

}  // namespace
}  // namespace tcert::table
