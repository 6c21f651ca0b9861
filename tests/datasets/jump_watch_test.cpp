#include "datasets/jump_watch.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tcert {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;

/// A parser's line at `time_s` whose only ray reads `value`, after one at `last_s`.
struct Line {
  std::vector<RayReading> readings;
  TickLine line;

  Line(double time_s, double last_s, double value, bool starts_anyway = false)
      : readings{{value, kMissing}} {
    line.is_after_gap = time_s - last_s > 1.0;
    line.starts_anyway = starts_anyway;
    line.tick = {static_cast<std::int64_t>(time_s * kSecondNs),
                 {},
                 readings,
                 false,
                 line.is_after_gap || starts_anyway};
  }
};

TEST(JumpWatch, HoldsATickAfterAGapUntilTheNextConfirmsIt) {
  JumpWatch watch(1, 1.0);
  EXPECT_EQ(watch.take(Line(0.0, 0.0, 0.1).line).usable.size(), 1U);
  {
    const Line far(50.0, 0.0, 0.2);  // whose readings are gone when the next line is read
    const JumpWatch::Verdict held = watch.take(far.line);
    EXPECT_TRUE(held.usable.empty());
    EXPECT_EQ(held.go_back_to_ns, 0);
  }
  const Line line1(50.1, 0.0, 0.3);
  const JumpWatch::Verdict both = watch.take(line1.line);
  ASSERT_EQ(both.usable.size(), 2U);
  EXPECT_EQ(both.usable[0].tick.rays[0].value, 0.2);
  EXPECT_TRUE(both.usable[0].tick.segment_start);
  EXPECT_FALSE(both.usable[1].tick.segment_start) << "the gap lies before the first of the two";
  EXPECT_FALSE(both.refused_ns);
}

// The first tick beyond ten times the trial limit starts a segment even where it confirms another.
TEST(JumpWatch, ALimitThatIsPassedByTheConfirmingTickIsABreak) {
  JumpWatch watch(1, 1.0);
  (void)watch.take(Line(0.0, 0.0, 0.1).line);
  (void)watch.take(Line(9.9, 0.0, 0.2).line);
  Line late(10.1, 9.9, 0.3);
  late.line.is_too_late = late.line.tick.segment_start = true;
  const JumpWatch::Verdict both = watch.take(late.line);
  ASSERT_EQ(both.usable.size(), 2U);
  EXPECT_TRUE(both.usable[1].tick.segment_start);
}

TEST(JumpWatch, RefusesAStampThatTheNextDoesNotConfirm) {
  JumpWatch watch(1, 1.0);
  (void)watch.take(Line(0.0, 0.0, 0.1).line);
  (void)watch.take(Line(1e6, 0.0, 0.2).line);
  const Line line2(0.1, 0.0, 0.3);
  const JumpWatch::Verdict verdict = watch.take(line2.line);
  EXPECT_EQ(verdict.refused_ns, static_cast<std::int64_t>(1e6) * kSecondNs);
  ASSERT_EQ(verdict.usable.size(), 1U);
  EXPECT_EQ(verdict.usable[0].tick.rays[0].value, 0.3);
  EXPECT_FALSE(verdict.usable[0].tick.segment_start);
  EXPECT_FALSE(watch.last());
}

TEST(JumpWatch, ThatAProducerCameBackIsNotForgottenWithItsFirstStamp) {
  JumpWatch watch(1, 1.0);
  (void)watch.take(Line(0.0, 0.0, 0.1).line);
  (void)watch.take(Line(1e6, 0.0, 0.2, true).line);
  const Line line3(0.1, 0.0, 0.3);
  const JumpWatch::Verdict verdict = watch.take(line3.line);
  ASSERT_EQ(verdict.usable.size(), 1U);
  EXPECT_TRUE(verdict.usable[0].tick.segment_start);
}

TEST(JumpWatch, HoldsTheNextIfThatIsFarAheadToo) {
  JumpWatch watch(1, 1.0);
  (void)watch.take(Line(0.0, 0.0, 0.1).line);
  (void)watch.take(Line(1e6, 0.0, 0.2).line);
  const Line line4(9.0, 0.0, 0.3);
  const JumpWatch::Verdict verdict = watch.take(line4.line);
  EXPECT_TRUE(verdict.usable.empty());
  EXPECT_TRUE(verdict.refused_ns);
  EXPECT_EQ(verdict.go_back_to_ns, 0);
  const auto last = watch.last();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->tick.time_ns, 9 * kSecondNs);
  EXPECT_EQ(last->tick.rays[0].value, 0.3);
}

}  // namespace
}  // namespace tcert
