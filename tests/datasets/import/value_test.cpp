#include "datasets/import/value.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tcert::recording {
namespace {

Value message() {
  Value point{
      Object{{"x", Value{1.5}}, {"n", Value{std::int64_t{-3}}}, {"name", Value{std::string("a")}}}};
  Value other{Object{{"x", Value{2.5}}}};
  return {Object{{"flag", Value{true}},
                 {"ranges", Value{Doubles{0.5, std::numeric_limits<double>::infinity()}}},
                 {"octets", Value{Octets{7, 255}}},
                 {"flags", Value{Flags{{0, 1}}}},
                 {"largest", Value{std::numeric_limits<std::uint64_t>::max()}},
                 {"nothing", Value{}},
                 {"points", Value{Array{point, other}}},
                 {"names", Value{Array{Value{std::string("b")}}}}}};
}

TEST(FieldPath, IsNamesAndIndices) {
  for (const char* good : {"a", "a.b", "a[0]", "a[12].b[3][4].c_d"}) {
    EXPECT_TRUE(field_path(good).has_value()) << good;
  }
  for (const char* bad : {"",
                          ".",
                          "a.",
                          ".a",
                          "a..b",
                          "[0]",
                          "a[]",
                          "a[-1]",
                          "a[1",
                          "a]",
                          "a[0]b",
                          "a[1x]",
                          "a[99999999999999999999]"}) {
    EXPECT_FALSE(field_path(bad).has_value()) << bad;
  }
  const auto path = field_path("a[12].b");
  ASSERT_EQ(path->steps.size(), 3U);
  EXPECT_EQ(path->steps[1].index, 12U);
  EXPECT_EQ(path->steps[2].name, "b");
}

TEST(Value, IsFoundByItsPath) {
  const Value root = message();
  ASSERT_NE(find(root, "points[1].x"), nullptr);
  EXPECT_EQ(number_at(root, "points[1].x"), 2.5);
  EXPECT_EQ(number_at(root, "ranges[0]"), 0.5);
  EXPECT_EQ(number_at(root, "octets[1]"), 255.0);
  EXPECT_EQ(number_at(root, "flags[1]"), 1.0);
  EXPECT_EQ(number_at(root, "flag"), 1.0);
  EXPECT_TRUE(std::isnan(*number_at(root, "nothing")));
  EXPECT_EQ(*text(*find(root, "names[0]")), "b");
  for (const char* none :
       {"points[2].x", "ranges[2]", "points.x", "flag.x", "missing", "ranges[0][0]", "ranges.x"}) {
    EXPECT_EQ(find(root, none), nullptr) << none;
    EXPECT_FALSE(number_at(root, none).has_value()) << none;
  }
  EXPECT_FALSE(number_at(root, "points[0].name").has_value());
  EXPECT_FALSE(number_at(root, "ranges").has_value());
}

TEST(Value, IntegersAreExact) {
  const Value root = message();
  EXPECT_EQ(integer(*find(root, "points[0].n")), -3);
  EXPECT_EQ(integer(*find(root, "flag")), 1);
  EXPECT_FALSE(integer(*find(root, "largest")).has_value());
  EXPECT_FALSE(integer(*find(root, "points[0].x")).has_value());
  const auto exact = (std::int64_t{1} << 53) + 1;
  EXPECT_EQ(integer(Value{exact}), exact);
  EXPECT_EQ(integer(Value{static_cast<std::uint64_t>(exact)}), exact);
}

TEST(Value, ArraysOfEveryKindAreNumbersOrNone) {
  std::vector<double> out{9.0};
  EXPECT_TRUE(append_numbers(Value{Doubles{1.5}}, out));
  EXPECT_TRUE(append_numbers(Value{Signed{-1}}, out));
  EXPECT_TRUE(append_numbers(Value{Unsigned{2}}, out));
  EXPECT_TRUE(append_numbers(Value{Octets{3}}, out));
  EXPECT_TRUE(append_numbers(Value{Flags{{1}}}, out));
  EXPECT_TRUE(append_numbers(Value{Array{Value{true}, Value{4.5}}}, out));
  const std::vector<double> all{9.0, 1.5, -1.0, 2.0, 3.0, 1.0, 1.0, 4.5};
  EXPECT_EQ(out, all);
  EXPECT_FALSE(append_numbers(Value{Array{Value{1.0}, Value{std::string("a")}}}, out));
  EXPECT_FALSE(append_numbers(Value{1.0}, out));
  EXPECT_EQ(out, all) << "nothing is appended of what is no array of numbers";
  EXPECT_TRUE(append_numbers(Value{Array{Value{}}}, out));
  EXPECT_TRUE(std::isnan(out.back()));
}

}  // namespace
}  // namespace tcert::recording
