#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <table/random.hpp>
#include <table/row_text.hpp>

namespace tcert::table {
namespace {

enum class Colour : std::uint8_t { red, green };

constexpr Colour row_last(Colour /*any*/) { return Colour::green; }

struct Point {
  double x = 0.0;
  std::optional<double> y;
  std::uint32_t count = 0;
  bool is_set = false;
  Colour colour = Colour::red;
  std::vector<std::uint8_t> list;
};

void row_cells(auto& row, Is<Point> auto& point) {
  row(point.x, point.y, point.count);
  row(point.is_set, point.colour, point.list);
}

TEST(RowText, ReadsBackWhatIsWrittenToTheBit) {
  RandomStream random(3, 1, 0);
  for (int i = 0; i < 2000; ++i) {
    Point point;
    point.x = std::ldexp(random.normal(), static_cast<int>(random.below(600)) - 300);
    point.y = i % 3 == 0 ? std::nullopt : std::optional(random.uniform());
    point.count = random.below(4000000000U);
    point.is_set = i % 2 == 0;
    point.colour = i % 5 == 0 ? Colour::green : Colour::red;
    point.list.assign(random.below(4), static_cast<std::uint8_t>(i));
    const auto back = from_row<Point>(row_text(point));
    EXPECT_EQ(back.x, point.x);
    EXPECT_EQ(back.y, point.y);
    EXPECT_EQ(back.count, point.count);
    EXPECT_EQ(back.is_set, point.is_set);
    EXPECT_EQ(back.colour, point.colour);
    EXPECT_EQ(back.list, point.list);
  }
}

TEST(RowText, HasNumbersThatAreNone) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(from_row<double>(row_text(-infinity)), -infinity);
  EXPECT_TRUE(std::isnan(from_row<double>(row_text(std::nan("")))));
  EXPECT_TRUE(std::signbit(from_row<double>(row_text(-0.0))));
}

TEST(RowText, RefusesEverythingElse) {
  const std::string good = row_text(Point{0.5, 0.25, 7, true, Colour::green, {1, 2}});
  ASSERT_EQ(good, "0.5,1,0.25,7,1,1,2,1,2");
  for (const char* const text : {"",
                                 ",",
                                 "0.5",
                                 "0.5,1,0.25,7,1,1,2,1",
                                 "0.5,1,0.25,7,1,1,2,1,2,3",
                                 "0.5,1,0.25,7,1,1,2,1,2,",
                                 "0.5,2,0.25,7,1,1,2,1,2",
                                 "0.5,1,0.25,-7,1,1,2,1,2",
                                 "0.5,1,0.25,7,1,1,2,1,256",
                                 "0.5,1,0.25,5000000000,1,1,2,1,2",
                                 "0.5,1,0.25,7,1,1,99999999999,1,2",
                                 "0.5,1,0.25,7,1,2,2,1,2",
                                 "0.5,1,0.25,7,1,1,2,1, 2",
                                 "half,1,0.25,7,1,1,2,1,2"}) {
    EXPECT_THROW(static_cast<void>(from_row<Point>(text)), RowError) << text;
  }
}

}  // namespace
}  // namespace tcert::table
