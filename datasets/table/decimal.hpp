#pragma once
/// \file
/// Decimal text to double, correctly rounded, and to integer nanoseconds, exactly.

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace tcert::table {

/// Largest |time_s| that is taken: differences of two such times fit in 64 bits of nanoseconds.
inline constexpr std::int64_t kLongestTimeS = 4'000'000'000;

namespace decimal_detail {

/// Where the digits, point and exponent of a number are; `end` is null if it is not a number.
struct Digits {
  std::uint64_t mantissa = 0;  ///< Modulo 2^64 when there are more than 19 digits.
  int exponent = 0;            ///< Of the last digit.
  std::int64_t count = 0;      ///< Leading zeros included.
  const char* end = nullptr;
};

[[nodiscard]] inline bool is_digit(char c) noexcept {
  return static_cast<unsigned char>(c - '0') < 10U;
}

[[nodiscard]] inline std::uint64_t load_eight(const char* p) noexcept {
  std::uint64_t word = 0;
  std::memcpy(&word, p, sizeof word);
  return word;
}

// Eight digits at once in one 64-bit word (Lemire, "Number parsing at a gigabyte per second",
// 2021).
[[nodiscard]] inline bool are_eight_digits(std::uint64_t word) noexcept {
  return ((word & 0xF0F0F0F0F0F0F0F0U) |
          (((word + 0x0606060606060606U) & 0xF0F0F0F0F0F0F0F0U) >> 4U)) == 0x3333333333333333U;
}

[[nodiscard]] inline std::uint64_t value_of_eight_digits(std::uint64_t word) noexcept {
  word -= 0x3030303030303030U;
  word = word * 10U + (word >> 8U);
  constexpr std::uint64_t kPairs = 0x000000FF000000FFU;
  return (((word & kPairs) * (100U + (1'000'000ULL << 32U))) +
          (((word >> 16U) & kPairs) * (1U + (10'000ULL << 32U)))) >>
         32U;
}

[[nodiscard]] inline const char* scan_digits(const char* p, std::uint64_t& mantissa) noexcept {
  if constexpr (std::endian::native == std::endian::little) {
    std::uint64_t word = load_eight(p);
    while (are_eight_digits(word)) {
      mantissa = mantissa * 100'000'000U + value_of_eight_digits(word);
      p += 8;
      word = load_eight(p);
    }
  }
  while (is_digit(*p)) {
    mantissa = mantissa * 10U + static_cast<std::uint64_t>(*p - '0');
    ++p;
  }
  return p;
}

/// Reads "e+12" at `p` into `exponent`, or leaves `p` where there is none.
[[nodiscard]] const char* scan_exponent(const char* p, int& exponent) noexcept;

[[nodiscard]] inline Digits scan(const char* p, char point) noexcept {
  Digits digits;
  const char* const whole = p;
  p = scan_digits(p, digits.mantissa);
  digits.count = p - whole;
  if (*p == point) {
    const char* const fraction = ++p;
    p = scan_digits(p, digits.mantissa);
    digits.count += p - fraction;
    digits.exponent = -static_cast<int>(p - fraction);
  }
  if (digits.count == 0) {
    return digits;
  }
  if (static_cast<char>(*p | 0x20) == 'e') {
    p = scan_exponent(p, digits.exponent);
  }
  digits.end = p;
  return digits;
}

/// The general case, by std::from_chars; null if the value is not finite.
[[nodiscard]] const char* scan_long_number(const char* begin,
                                           const char* end,
                                           char point,
                                           double& value) noexcept;

inline constexpr std::array<double, 23> kPowersOfTen{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

}  // namespace decimal_detail

/// Reads the number at `p`: sign, digits, `point`, digits, exponent. Returns where it ends, or null
/// if there is no finite number; a value below the smallest double is 0. The result is the double
/// nearest to the decimal.
///
/// Fast path: with at most 2^53 as digits and a power of ten up to 22 both are exact doubles, so
/// one multiplication or division rounds once (Clinger 1990); everything else goes to
/// std::from_chars. \pre a byte that cannot belong to a number follows within the buffer, and eight
/// more after it.
[[nodiscard]] inline const char* scan_number(const char* p, char point, double& value) noexcept {
  using namespace decimal_detail;
  const char* const begin = p;
  const bool negative = *p == '-';
  p += (negative || *p == '+') ? 1 : 0;
  const Digits digits = scan(p, point);
  if (digits.end == nullptr) {
    return nullptr;
  }
  constexpr std::uint64_t kExactIntegers = std::uint64_t{1} << 53U;
  if (digits.count > 19 || digits.mantissa > kExactIntegers || digits.exponent < -22 ||
      digits.exponent > 22) {
    return scan_long_number(begin, digits.end, point, value);
  }
  const auto mantissa = static_cast<double>(digits.mantissa);
  const double magnitude = digits.exponent < 0
                               ? mantissa / kPowersOfTen[static_cast<std::size_t>(-digits.exponent)]
                               : mantissa * kPowersOfTen[static_cast<std::size_t>(digits.exponent)];
  value = negative ? -magnitude : magnitude;
  return digits.end;
}

/// Reads seconds at `p` as nanoseconds: exact to nine decimals, further ones are rounded half away
/// from zero. Returns where it ends, or null if there is no time within kLongestTimeS.
/// \pre as scan_number.
[[nodiscard]] const char* scan_seconds(const char* p, char point, std::int64_t& time_ns) noexcept;

}  // namespace tcert::table
