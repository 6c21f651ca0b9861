#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tcert/elementary.hpp>

namespace tcert::elementary {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// ln 2 and pi/2 in parts. The high parts end in zeros, so that their products with a whole number
// of up to 20 bits are exact.
constexpr double kLn2High = 0x1.62e42fee00000p-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
constexpr double kQuarterHigh = 0x1.921fb54400000p+0;
constexpr double kQuarterMiddle = 0x1.0b4611a600000p-34;
constexpr double kQuarterLow = 0x1.3198a2e037073p-69;
constexpr double kHalfPi = 0x1.921fb54442d18p+0;
constexpr double kHalfPiLow = 0x1.1a62633145c07p-54;

/// c[0] + c[1] x + ... + c[N - 1] x^(N-1), pairs first, so that few products wait for one another.
template <std::size_t N>
double polynomial(const std::array<double, N>& c, double x) noexcept {
  if constexpr (N == 1) {
    return c[0];
  } else if constexpr (N == 2) {
    return c[0] + c[1] * x;
  } else {
    std::array<double, (N + 1) / 2> pairs{};
    for (std::size_t i = 0; i + 1 < N; i += 2) {
      pairs[i / 2] = c[i] + c[i + 1] * x;
    }
    if constexpr (N % 2 == 1) {
      pairs.back() = c.back();
    }
    return polynomial(pairs, x * x);
  }
}

double power_of_two(int exponent) noexcept {
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
}

/// value 2^exponent, rounded once, for value in [0.5, 2] and exponent in [-1080, 1025].
double scaled(double value, int exponent) noexcept {
  if (exponent > 1000) {
    return value * power_of_two(exponent - 2) * 4.0;
  }
  if (exponent < -1000) {
    return value * power_of_two(exponent + 100) * power_of_two(-100);
  }
  return value * power_of_two(exponent);
}

/// Taylor coefficients 1/n! of e^r from r^2 on: below 2^-57 off for |r| <= ln(2)/2.
constexpr std::array<double, 12> kExp = [] {
  std::array<double, 12> c{};
  double factorial = 1.0;  // exact up to 18!
  for (std::size_t n = 0; n < c.size(); ++n) {
    factorial *= static_cast<double>(n + 2);
    c[n] = 1.0 / factorial;
  }
  return c;
}();

/// ln(2)^n / n!, from n = 2 on: 2^r likewise for |r| <= 1/2.
constexpr std::array<double, 12> kExp2 = {0x1.ebfbdff82c58fp-3,
                                          0x1.c6b08d704a0c0p-5,
                                          0x1.3b2ab6fba4e77p-7,
                                          0x1.5d87fe78a6731p-10,
                                          0x1.430912f86c787p-13,
                                          0x1.ffcbfc588b0c7p-17,
                                          0x1.62c0223a5c824p-20,
                                          0x1.b5253d395e7c4p-24,
                                          0x1.e4cf5158b8ecap-28,
                                          0x1.e8cac7351bb25p-32,
                                          0x1.c3bd650fc2986p-36,
                                          0x1.816193166d0f9p-40};
constexpr double kLn2 = 0x1.62e42fefa39efp-1;
constexpr double kLn2Rest = 0x1.abc9e3b39803fp-56;

/// 2/(2n + 3), n = 0, 1, ...: atanh(s) = s + s^3/3 + ... twice, for |s| < 0.172.
constexpr std::array<double, 11> kLog = [] {
  std::array<double, 11> c{};
  for (std::size_t n = 0; n < c.size(); ++n) {
    c[n] = 2.0 / static_cast<double>(2 * n + 3);
  }
  return c;
}();

/// Taylor coefficients of sine from x^3 and of cosine from x^4, in powers of x^2, |x| <= pi/4.
template <std::size_t N>
constexpr std::array<double, N> alternating(unsigned first, double sign) {
  std::array<double, N> c{};
  double factorial = 1.0;
  unsigned n = 1;
  for (std::size_t i = 0; i < N; ++i) {
    for (; n <= first + 2 * static_cast<unsigned>(i); ++n) {
      factorial *= static_cast<double>(n);
    }
    c[i] = sign / factorial;
    sign = -sign;
  }
  return c;
}
constexpr auto kSine = alternating<8>(3, -1.0);
constexpr auto kCosine = alternating<8>(4, 1.0);

/// atan(k/8) = kAtan[k] + kAtanLow[k].
constexpr std::array<double, 9> kAtan = {0.0,
                                         0x1.fd5ba9aac2f6ep-4,
                                         0x1.f5b75f92c80ddp-3,
                                         0x1.6f61941e4def1p-2,
                                         0x1.dac670561bb4fp-2,
                                         0x1.1e00babdefeb4p-1,
                                         0x1.4978fa3269ee1p-1,
                                         0x1.700a7c5784634p-1,
                                         0x1.921fb54442d18p-1};
constexpr std::array<double, 9> kAtanLow = {0.0,
                                            -0x1.cd37686760c17p-59,
                                            0x1.8ab6e3cf7afbdp-57,
                                            -0x1.c63aae6f6e918p-56,
                                            0x1.a2b7f222f65e2p-56,
                                            -0x1.928df287a668fp-58,
                                            0x1.2419a87f2a458p-56,
                                            -0x1.8c34d25aadef6p-56,
                                            0x1.1a62633145c07p-55};
constexpr std::array<double, 7> kAtanSeries = {
    -1.0 / 3.0, 1.0 / 5.0, -1.0 / 7.0, 1.0 / 9.0, -1.0 / 11.0, 1.0 / 13.0, -1.0 / 15.0};

/// The angle of (x, y), 0 <= y <= x, x > 0, as a sum of two.
struct Angle {
  double high;
  double low;
};
Angle first_octant(double y, double x) noexcept {
  const double nearest = std::floor(8.0 * (y / x) + 0.5);
  const double c = 0.125 * nearest;
  const double u = (y - c * x) / (x + c * y);
  const double square = u * u;
  const auto k = static_cast<std::size_t>(nearest);
  const double rest = u + (u * square * polynomial(kAtanSeries, square) + kAtanLow[k]);
  return {kAtan[k], rest};
}

}  // namespace

double exp(double x) noexcept {
  if (!(x < 709.79)) {
    return std::isnan(x) ? x : kInfinity;  // NOLINT(bugprone-narrowing-conversions): it is none.
  }
  if (x < -745.2) {
    return 0.0;
  }
  const double k = std::floor(x * (1.0 / kLn2) + 0.5);
  const double high = x - k * kLn2High;
  const double low = k * kLn2Low;
  const double r = high - low;
  const double lost = (high - r) - low;
  const double square = r * r;
  const double power = 1.0 + (r + (square * polynomial(kExp, r) + lost));
  return scaled(power, static_cast<int>(k));
}

double exp2(double x) noexcept {
  if (!(x < 1024.0)) {
    return std::isnan(x) ? x : kInfinity;  // NOLINT(bugprone-narrowing-conversions): it is none.
  }
  if (x < -1075.0) {
    return 0.0;
  }
  const double k = std::floor(x + 0.5);
  const double r = x - k;
  const double power = 1.0 + (r * kLn2 + (r * r * polynomial(kExp2, r) + r * kLn2Rest));
  return scaled(power, static_cast<int>(k));
}

double log(double x) noexcept {
  if (!(x > 0.0)) {
    return x == 0.0 ? -kInfinity : kNaN;
  }
  if (x == kInfinity) {
    return x;
  }
  int shift = 0;
  if (x < std::numeric_limits<double>::min()) {
    x *= 0x1p54;
    shift = -54;
  }
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto k = static_cast<int>(bits >> 52U) - 1023;
  auto m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFULL) | 0x3FF0000000000000ULL);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++k;
  }
  const double f = m - 1.0;
  const double s = f / (2.0 + f);
  const double square = s * s;
  // log(1 + f) = 2 atanh(s) = f - (f^2/2 - s (f^2/2 + rest)), the small parts first.
  const double half = 0.5 * f * f;
  const double rest = square * polynomial(kLog, square);
  const auto n = static_cast<double>(k + shift);
  return n * kLn2High + (f - (half - (s * (half + rest) + n * kLn2Low)));
}

SineCosine sine_cosine(double angle_rad) noexcept {
  if (!std::isfinite(angle_rad)) {
    return {kNaN, kNaN};
  }
  constexpr double kFar = 1e5;
  if (std::abs(angle_rad) > kFar) {
    angle_rad = std::remainder(angle_rad, 4.0 * kHalfPi);
  }
  const double quarters = std::floor(angle_rad * (1.0 / kHalfPi) + 0.5);
  const double high = angle_rad - quarters * kQuarterHigh;
  const double middle = quarters * kQuarterMiddle;
  const double nearly = high - middle;
  const double low = quarters * kQuarterLow - ((high - nearly) - middle);
  const double r = nearly - low;
  const double lost = (nearly - r) - low;
  const double square = r * r;
  // sin(r + lost) and cos(r + lost), to the first power of lost.
  const double sine = r + (r * square * polynomial(kSine, square) + lost);
  const double half = 0.5 * square;
  const double near_one = 1.0 - half;
  const double cosine = near_one + (((1.0 - near_one) - half) +
                                    (square * square * polynomial(kCosine, square) - r * lost));
  switch (static_cast<std::int64_t>(quarters) & 3) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

double tan(double angle_rad) noexcept {
  const auto [sine, cosine] = sine_cosine(angle_rad);
  return sine / cosine;
}

double atan2(double y, double x) noexcept {
  if (std::isnan(x) || std::isnan(y)) {
    return x + y;
  }
  // A power of two keeps sums and products below from overflow and underflow.
  const double larger = std::abs(x) > std::abs(y) ? std::abs(x) : std::abs(y);
  const double scale = larger > 0x1p+1000 ? 0x1p-100 : larger < 0x1p-900 ? 0x1p+300 : 1.0;
  const double across = scale * std::abs(y);
  const double along = scale * std::abs(x);
  double angle = 0.0;
  if (across <= along) {
    if (along > 0.0) {
      const auto [high, low] = first_octant(across, along);
      angle = high + low;
      if (x < 0.0) {
        angle = 2.0 * kHalfPi - (high - (2.0 * kHalfPiLow - low));
      }
    }
  } else {
    const auto [high, low] = first_octant(along, across);
    angle = x < 0.0 ? kHalfPi + (high + (low + kHalfPiLow)) : kHalfPi - (high - (kHalfPiLow - low));
  }
  return std::signbit(y) ? -angle : angle;
}

double asin(double x) noexcept { return atan2(x, std::sqrt((1.0 - x) * (1.0 + x))); }
double acos(double x) noexcept { return atan2(std::sqrt((1.0 - x) * (1.0 + x)), x); }

}  // namespace tcert::elementary
