#include <table/decimal.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <table/bytes.hpp>
#include <table/csv_write.hpp>

namespace tcert::table {
namespace {

/// The whole of `text` as a number.
std::optional<double> number(std::string_view text, char point = '.') {
  const Bytes bytes = Bytes::copy_of(text);
  double value = 0.0;
  const char* const begin = bytes.view().data();
  if (scan_number(begin, point, value) != begin + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> nanoseconds(std::string_view text, char point = '.') {
  const Bytes bytes = Bytes::copy_of(text);
  std::int64_t value = 0;
  const char* const begin = bytes.view().data();
  if (scan_seconds(begin, point, value) != begin + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::string random_decimal(std::mt19937_64& random) {
  std::string text = random() % 3 == 0 ? "-" : "";
  const std::size_t digits = 1 + random() % 22;
  const std::size_t point = random() % (digits + 1);
  for (std::size_t i = 0; i < digits; ++i) {
    text += i == point ? "." : "";
    text += static_cast<char>('0' + random() % 10);
  }
  if (random() % 4 == 0) {
    text += random() % 2 == 0 ? "e" : "E";
    text += random() % 2 == 0 ? "-" : "+";
    text += std::to_string(random() % (random() % 8 == 0 ? 340 : 30));
  }
  return text;
}

TEST(ScanNumber, GivesTheSameBitsAsFromCharsOnTwoMillionDecimals) {
  std::mt19937_64 random(1);
  Bytes bytes;
  for (int i = 0; i < 2'000'000; ++i) {
    const std::string text = random_decimal(random);
    double expected = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
    if (error != std::errc{}) {
      continue;
    }
    bytes.assign(text);
    double value = 0.0;
    const char* const begin = bytes.view().data();
    ASSERT_EQ(scan_number(begin, '.', value), begin + text.size()) << text;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(value), std::bit_cast<std::uint64_t>(expected)) << text;
  }
}

TEST(ScanNumber, ReadsBackEveryWrittenDoubleToTheBit) {
  std::mt19937_64 random(2);
  std::string text;
  for (int i = 0; i < 500'000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (!std::isfinite(value)) {
      continue;
    }
    text.clear();
    append_number(text, value);
    ASSERT_EQ(number(text), value) << text;
  }
}

TEST(ScanNumber, TakesTheFormsThatLoggersWrite) {
  EXPECT_EQ(number("+1.5"), 1.5);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("5."), 5.0);
  EXPECT_EQ(number("1,5", ','), 1.5);
  EXPECT_EQ(number("0,12345678901234567890", ','), 0.12345678901234567890);
  EXPECT_EQ(number("1e-400"), 0.0);
  EXPECT_TRUE(std::signbit(*number("-1e-400")));
}

TEST(ScanNumber, TakesNothingThatIsNotFinite) {
  for (const char* text :
       {"", "-", ".", "nan", "inf", "-inf", "1e999", "-1e309", "e5", "abc", "+-1"}) {
    EXPECT_EQ(number(text), std::nullopt) << text;
  }
}

TEST(ScanNumber, StopsBeforeTextAfterTheNumber) {
  for (const char* text : {"1x", "1.2.3", "1e", "1e+", "0x10", "1 2", "1,5"}) {
    EXPECT_EQ(number(text), std::nullopt) << text;
  }
}

TEST(ScanSeconds, IsExactToTheNanosecond) {
  EXPECT_EQ(nanoseconds("0.1"), 100'000'000);
  EXPECT_EQ(nanoseconds("-0.000000001"), -1);
  EXPECT_EQ(nanoseconds("1727800000.123456789"), 1'727'800'000'123'456'789);
  EXPECT_EQ(nanoseconds("12"), 12'000'000'000);
  EXPECT_EQ(nanoseconds("1.5e-3"), 1'500'000);
  EXPECT_EQ(nanoseconds("1.5E2"), 150'000'000'000);
  EXPECT_EQ(nanoseconds("0,25", ','), 250'000'000);
}

TEST(ScanSeconds, RoundsBelowTheNanosecondHalfAwayFromZero) {
  EXPECT_EQ(nanoseconds("0.0092704296112"), 9'270'430);
  EXPECT_EQ(nanoseconds("0.0000000005"), 1);
  EXPECT_EQ(nanoseconds("-0.0000000005"), -1);
  EXPECT_EQ(nanoseconds("0.00000000049999999999999999999"), 0);
  EXPECT_EQ(nanoseconds("3999999999.9999999994"), 3'999'999'999'999'999'999);
  EXPECT_EQ(nanoseconds("3999999999.9999999995"), 4'000'000'000'000'000'000);
  EXPECT_EQ(nanoseconds("1727800000.12345678950000000000"), 1'727'800'000'123'456'790);
  EXPECT_EQ(nanoseconds("0000000000000000000000000.5"), 500'000'000);
}

TEST(ScanSeconds, RefusesWhatDoesNotFit) {
  for (const char* text : {"4000000000.000000001", "1e30", "99999999999999999999999", "x", ""}) {
    EXPECT_EQ(nanoseconds(text), std::nullopt) << text;
  }
  EXPECT_EQ(nanoseconds("0e99999"), 0);
  EXPECT_EQ(nanoseconds("1e-99999"), 0);
}

TEST(AppendSeconds, ReadsBackToTheSameNanosecond) {
  std::mt19937_64 random(3);
  std::string text;
  for (int i = 0; i < 200'000; ++i) {
    const auto time = static_cast<std::int64_t>(random() % 8'000'000'000'000'000'001U) -
                      4'000'000'000'000'000'000;
    text.clear();
    append_seconds(text, time);
    ASSERT_EQ(nanoseconds(text), time) << text;
  }
}

TEST(AppendSeconds, WritesNoTrailingZeros) {
  std::string text;
  append_seconds(text, 1'500'000'000);
  append_seconds(text, -2'000'000'000);
  EXPECT_EQ(text, "1.5-2");
}

TEST(AppendText, QuotesOnlyWhatNeedsIt) {
  std::string text;
  append_text(text, "plain");
  append_text(text, "a,\"b\"");
  EXPECT_EQ(text, "plain\"a,\"\"b\"\"\"");
}

}  // namespace
}  // namespace tcert::table
