#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <tcert/elementary.hpp>
#include <utility>
#include <vector>

namespace tcert {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Error of `value` in units of the last place of the exact result.
double units_off(double value, long double exact) {
  int exponent = 0;
  std::frexp(static_cast<double>(exact), &exponent);
  const long double unit = std::ldexp(1.0L, std::max(exponent - 53, -1074));
  return static_cast<double>(std::abs(static_cast<long double>(value) - exact) / unit);
}

/// Largest error at `n` places spread over [low, high] by the golden ratio, the reference in 64
/// bits.
template <typename Own, typename Exact>
double largest_error(Own own, Exact exact, double low, double high) {
  double worst = 0.0;
  double share = 0.5;
  for (int i = 0; i < 200'000; ++i) {
    share += 0.6180339887498949;
    share -= std::floor(share);
    const double x = low + share * (high - low);
    worst = std::max(worst, units_off(own(x), exact(static_cast<long double>(x))));
  }
  return worst;
}

TEST(Elementary, ErrorsAreAsStated) {
  using Long = long double;
  const auto exp = [](Long x) { return std::exp(x); };
  const auto exp2 = [](Long x) { return std::exp2(x); };
  const auto log = [](Long x) { return std::log(x); };
  const auto sin = [](Long x) { return std::sin(x); };
  const auto cos = [](Long x) { return std::cos(x); };
  EXPECT_LT(largest_error(elementary::exp, exp, -1.0, 1.0), 1.0);
  EXPECT_LT(largest_error(elementary::exp, exp, -745.0, 709.0), 1.01);
  EXPECT_LT(largest_error(elementary::exp2, exp2, -1.0, 1.0), 1.1);
  EXPECT_LT(largest_error(elementary::exp2, exp2, -1074.0, 1023.0), 1.1);
  EXPECT_LT(largest_error(elementary::log, log, 0.0, 2.0), 1.0);
  EXPECT_LT(largest_error(elementary::log, log, 0.0, 1e10), 1.0);
  EXPECT_LT(largest_error(elementary::log, log, 0.0, 1e-308), 1.0);
  EXPECT_LT(largest_error(elementary::sin, sin, -7.0, 7.0), 1.0);
  EXPECT_LT(largest_error(elementary::cos, cos, -7.0, 7.0), 1.0);
  EXPECT_LT(largest_error(elementary::sin, sin, -1e5, 1e5), 1.0);
  EXPECT_LT(largest_error(elementary::cos, cos, -1e5, 1e5), 1.0);
  EXPECT_LT(largest_error(
                elementary::tan, [](Long x) { return std::tan(x); }, -2.0, 2.0),
            2.5);
  EXPECT_LT(largest_error(
                elementary::asin, [](Long x) { return std::asin(x); }, -1.0, 1.0),
            2.5);
  EXPECT_LT(largest_error(
                elementary::acos, [](Long x) { return std::acos(x); }, -1.0, 1.0),
            2.5);
  for (const double y : {1.0, -1.0, 1e-3, 0.5}) {
    const auto own = [y](double x) { return elementary::atan2(y, x); };
    const auto exact = [y](Long x) { return std::atan2(static_cast<Long>(y), x); };
    EXPECT_LT(largest_error(own, exact, -3.0, 3.0), 2.5) << y;
  }
}

TEST(Elementary, AnglesNearMultiplesOfARightAngleKeepTheirDigits) {
  double worst = 0.0;
  for (int k = 1; k < 60'000; ++k) {
    const double x = k * (0.5 * std::numbers::pi);
    const auto [sine, cosine] = elementary::sine_cosine(x);
    worst = std::max(worst, units_off(sine, std::sin(static_cast<long double>(x))));
    // Near a zero the reference itself has some digits fewer than it has elsewhere.
    worst = std::max(worst, units_off(cosine, std::cos(static_cast<long double>(x))));
  }
  EXPECT_LT(worst, 1.01);
}

TEST(Elementary, EndsOfTheRange) {
  EXPECT_EQ(elementary::exp(0.0), 1.0);
  EXPECT_EQ(elementary::exp(-0.0), 1.0);
  EXPECT_EQ(elementary::exp(710.0), kInfinity);
  EXPECT_EQ(elementary::exp(-746.0), 0.0);
  EXPECT_GT(elementary::exp(709.7), 0.0);
  EXPECT_GT(elementary::exp(-745.0), 0.0);
  EXPECT_EQ(elementary::exp(kInfinity), kInfinity);
  EXPECT_EQ(elementary::exp(-kInfinity), 0.0);
  EXPECT_TRUE(std::isnan(elementary::exp(std::nan(""))));
  for (int k = -1074; k < 1024; ++k) {
    EXPECT_EQ(elementary::exp2(k), std::ldexp(1.0, k));
  }
  EXPECT_EQ(elementary::exp2(1024.0), kInfinity);
  EXPECT_EQ(elementary::exp2(-1e300), 0.0);
  EXPECT_TRUE(std::isnan(elementary::exp2(std::nan(""))));
  EXPECT_EQ(elementary::log(1.0), 0.0);
  EXPECT_EQ(elementary::log(0.0), -kInfinity);
  EXPECT_EQ(elementary::log(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(elementary::log(-1.0)));
  EXPECT_EQ(elementary::sin(0.0), 0.0);
  EXPECT_EQ(elementary::cos(0.0), 1.0);
  EXPECT_TRUE(std::isnan(elementary::sin(kInfinity)));
  EXPECT_LE(std::abs(elementary::sin(1e300)), 1.0);
  EXPECT_EQ(elementary::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(elementary::atan2(0.0, -1.0), std::numbers::pi);
  EXPECT_EQ(elementary::atan2(-1.0, 0.0), -0.5 * std::numbers::pi);
  EXPECT_EQ(elementary::atan2(1.0, 1.0), 0.25 * std::numbers::pi);
  for (const auto& [y, x] : {std::pair{1.6e308, 1.7e308},
                             std::pair{1e308, 1.7e308},
                             std::pair{1.5e308, 1e308},
                             std::pair{5e-324, 1.5e-323},
                             std::pair{1e-310, 1e-300}}) {
    EXPECT_NEAR(elementary::atan2(y, x) / std::atan2(y, x), 1.0, 1e-15) << y << ' ' << x;
  }
  EXPECT_TRUE(std::isnan(elementary::atan2(std::nan(""), 1.0)));
  EXPECT_TRUE(std::isnan(elementary::asin(1.1)));
  EXPECT_EQ(elementary::asin(1.0), 0.5 * std::numbers::pi);
  EXPECT_EQ(elementary::acos(-1.0), std::numbers::pi);
}

/// One number of the bits of all functions at many places: whoever builds them, and wherever they
/// run, gets this one.
TEST(Elementary, SameBitsEverywhere) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&](double value) {
    hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3ULL;
  };
  for (int i = 0; i < 100'000; ++i) {
    const double x = 1e-3 * i - 50.0 + 1e-7 * (i % 97);
    const double share = 2e-5 * i - 1.0;
    const auto [sine, cosine] = elementary::sine_cosine(x);
    add(elementary::exp(x));
    add(elementary::exp2(x));
    add(elementary::log(x * x + 1e-9));
    add(sine);
    add(cosine);
    add(elementary::tan(x));
    add(elementary::atan2(sine, x));
    add(elementary::asin(share));
    add(elementary::acos(share));
  }
  EXPECT_EQ(hash, 13449685444833834842ULL);
}

}  // namespace
}  // namespace tcert
