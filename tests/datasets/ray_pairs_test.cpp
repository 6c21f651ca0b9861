#include "datasets/ray_pairs.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tcert {
namespace {

struct Read {
  std::optional<RayPairs> pairs;
  std::vector<std::string> messages;
};

Read read(std::string_view text) {
  table::CsvOptions csv;
  csv.file = "pairs.csv";
  RayPairsResult result = read_ray_pairs(table::Bytes::copy_of(text), csv);
  Read out{std::move(result.pairs), {}};
  for (const table::Diagnostic& one : result.diagnostics) {
    out.messages.push_back(table::to_string(one));
  }
  return out;
}

constexpr const char* kHeader = "ray,run,day,bend_rad,clearance_m\n";

/// `count` rows of one ray on one day.
std::string rows(int count, const std::string& bend, const std::string& clearance) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += "left,1,d1," + bend + "," + clearance + "\n";
  }
  return text;
}

TEST(RayPairs, AreReadByTheNamesOfTheColumns) {
  const Read one = read(
      "note;day;clearance_m;bend_rad;run;ray\n"
      "x;2024-02-01;0.3;0.1;1;right\n"
      ";2024-01-31;0.2;0.4;1;left\n"
      ";2024-02-01;0.25;0.3;1;left\n"
      ";2024-02-01;;0.3;2;left\n"
      ";2024-02-03;NA;0.3;2;left\n");
  EXPECT_EQ(one.messages,
            (std::vector<std::string>{"pairs.csv: note: found '2 rows without a bend or a "
                                      "clearance', expected both in each; they are left out"}));
  const RayPairs& pairs = one.pairs.value();
  EXPECT_EQ(pairs.rays, (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(pairs.days, (std::vector<std::string>{"2024-01-31", "2024-02-01"}))
      << "a day without a pair is no unit";
  ASSERT_EQ(pairs.pairs.size(), 3U);
  EXPECT_EQ(pairs.pairs[0].ray, 1U);
  EXPECT_EQ(pairs.pairs[0].day, 1U);
  EXPECT_EQ(pairs.pairs[0].bend_rad, 0.1);
  EXPECT_EQ(pairs.pairs[0].clearance_m, 0.3);
  EXPECT_EQ(pairs.runs, 2U) << "run 1 of two days";
  EXPECT_EQ(pairs.missing, 2U);
  EXPECT_FALSE(pairs.synthetic);
}

TEST(RayPairs, NameWhatCannotBeUsed) {
  const Read bad =
      read(std::string(kHeader) + "left,1,d1,far,0.2\n,1,d1,0.1,0.2\nleft,1,,0.1,inf\n");
  EXPECT_FALSE(bad.pairs);
  EXPECT_EQ(bad.messages,
            (std::vector<std::string>{
                "pairs.csv:2: error: column 'bend_rad': found 'far', expected a finite number (a "
                "missing cell is empty, NA or nan)",
                "pairs.csv:4: error: column 'clearance_m': found 'inf', expected a finite number "
                "(a missing cell is empty, NA or nan)",
                "pairs.csv:3: error: column 'ray': expected a name",
                "pairs.csv: note: found '2 rows without a bend or a clearance', expected both in "
                "each; they are left out"}));
  EXPECT_EQ(read("ray,run,day,bend,clearance_m\nleft,1,d1,0.1,0.2\n").messages,
            (std::vector<std::string>{"pairs.csv:1: error: column 'bend_rad': found 'bend', "
                                      "expected a column of this name in the header"}));
  EXPECT_EQ(read(kHeader).messages.back(),
            "pairs.csv: error: found 'no pair', expected rows with a bend and a clearance");
}

TEST(RayPairs, AreAskedForTheirUnitsWhereTheyCannotBeRight) {
  const Read degrees = read(kHeader + rows(4, "0.3", "0.2") + rows(2, "35", "0.2"));
  EXPECT_FALSE(degrees.pairs);
  EXPECT_EQ(degrees.messages,
            (std::vector<std::string>{"pairs.csv:6: error: column 'bend_rad': found '35', expected "
                                      "bends in radians, -3.2 to 3.2: degrees? (and 1 more)"}));
  const Read millimetres = read(kHeader + rows(9, "0.3", "212"));
  EXPECT_FALSE(millimetres.pairs);
  EXPECT_NE(millimetres.messages.at(0).find("at most 10: millimetres? (and 8 more)"),
            std::string::npos);
  const Read few = read(kHeader + rows(20, "-0.3", "0.2") + rows(1, "-35", "-0.01"));
  ASSERT_TRUE(few.pairs);
  EXPECT_EQ(few.messages,
            (std::vector<std::string>{
                "pairs.csv:22: warning: column 'bend_rad': found '-35', expected bends in radians, "
                "-3.2 to 3.2: degrees?",
                "pairs.csv:22: warning: column 'clearance_m': found '-0.01', expected clearances "
                "of 0 or more; a negative one counts as 0"}));
  EXPECT_EQ(few.pairs->pairs.back().clearance_m, 0.0);
}

TEST(RayPairs, OfMadeDataSaySo) {
  const Read made = read("ray,run,day,bend_rad,clearance_m,synthetic_seed\nleft,1,d1,0.1,0.2,7\n");
  EXPECT_TRUE(made.pairs.value().synthetic);
  EXPECT_EQ(made.pairs->seed, 7U);
}

}  // namespace
}  // namespace tcert
