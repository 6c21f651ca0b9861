#include <gtest/gtest.h>

#include <cstddef>
#include <tcert/struct_size.hpp>

namespace tcert {
namespace {

/// As an older caller was compiled, and as it is now: `gain` was appended.
struct Older {
  std::uint32_t struct_size = sizeof(Older);
  std::uint32_t count = 0;
  double width_m = 0.0;
};
struct Now {
  std::uint32_t struct_size = sizeof(Now);
  std::uint32_t count = 0;
  double width_m = 0.0;
  double gain = 7.0;
};

}  // namespace

template <>
inline constexpr std::size_t kFirstSize<Now> = offsetof(Now, width_m) + sizeof(double);

namespace {

/// An older caller's struct and, behind it, memory that is not the library's.
struct OlderCaller {
  Older given;
  double own = 42.0;
  Now& as_now() { return reinterpret_cast<Now&>(given); }
};

TEST(StructSize, KnowsAllVersionsUpToItsOwn) {
  EXPECT_TRUE(is_known_size<Now>(sizeof(Older)));
  EXPECT_TRUE(is_known_size<Now>(sizeof(Now)));
  EXPECT_FALSE(is_known_size<Now>(sizeof(Now) + 8)) << "a newer caller";
  EXPECT_FALSE(is_known_size<Now>(sizeof(Older) - 1));
  EXPECT_FALSE(is_known_size<Now>(0));
  EXPECT_FALSE(is_known_size<Now>(sizeof(Now) - 1)) << "a member that is cut short";
}

TEST(StructSize, AppendedMembersOfAnOlderCallerTakeTheirDefaults) {
  OlderCaller caller;
  caller.given = {sizeof(Older), 3, 0.5};
  const Now whole = completed(caller.as_now(), Now{});
  EXPECT_EQ(whole.struct_size, sizeof(Now));
  EXPECT_EQ(whole.count, 3U);
  EXPECT_EQ(whole.width_m, 0.5);
  EXPECT_EQ(whole.gain, 7.0) << "not the caller's own memory";
}

TEST(StructSize, WritesNothingBehindAnOlderCaller) {
  OlderCaller caller;
  give(Now{sizeof(Now), 9, 1.5, 2.5}, caller.as_now());
  EXPECT_EQ(caller.given.struct_size, sizeof(Older));
  EXPECT_EQ(caller.given.count, 9U);
  EXPECT_EQ(caller.given.width_m, 1.5);
  EXPECT_EQ(caller.own, 42.0);
}

}  // namespace
}  // namespace tcert
