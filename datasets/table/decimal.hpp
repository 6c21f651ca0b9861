#pragma once
/// \file
/// Decimal text to double, correctly rounded, and to integer nanoseconds, exactly.

#include <array>
#include <bit>
#include <cstddef>
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

inline constexpr std::uint64_t kZeros = 0x3030303030303030U;

// Eight digits at once in one 64-bit word (Lemire, "Number parsing at a gigabyte per second",
// 2021).
[[nodiscard]] inline bool are_eight_digits(std::uint64_t word) noexcept {
  return ((word & 0xF0F0F0F0F0F0F0F0U) |
          (((word + 0x0606060606060606U) & 0xF0F0F0F0F0F0F0F0U) >> 4U)) == 0x3333333333333333U;
}

/// \pre the bytes are 0 to 9, the first digit lowest.
[[nodiscard]] inline std::uint64_t value_of_eight_digits(std::uint64_t word) noexcept {
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
      mantissa = mantissa * 100'000'000U + value_of_eight_digits(word ^ kZeros);
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

/// A number of the kind that most cells have: a minus or none, and at most seven bytes of digits
/// and a point.
struct ShortNumber {
  std::uint64_t mantissa = 0;
  std::size_t decimals = 0;    ///< 0 to 6.
  std::uint64_t negative = 0;  ///< 1 or 0.
  const char* end = nullptr;   ///< Null of anything else, such as a longer number or an exponent.
};

/// Eight bytes at once, and no branch on how many digits there are or where; where the number ends
/// is known first, so that the next one can be begun. \pre as scan_number.
[[nodiscard, gnu::always_inline]] inline ShortNumber scan_short(const char* p,
                                                                char point) noexcept {
  if constexpr (std::endian::native != std::endian::little) {
    return {};
  }
  constexpr std::uint64_t kHighBits = 0x8080808080808080U;
  const std::uint64_t negative = *p == '-' ? 1U : 0U;
  const std::uint64_t text = load_eight(negative != 0 ? p + 1 : p);
  const std::uint64_t digit = text ^ kZeros;  // bytes of digits are 0 to 9
  const std::uint64_t other = text ^ (0x0101010101010101U * static_cast<unsigned char>(point));
  // High bits of the bytes that are no digits, and of those that are no points either.
  const std::uint64_t no_digit = ((digit & ~kHighBits) + 0x7676767676767676U) | digit;
  const std::uint64_t no_point = ((other & ~kHighBits) + ~kHighBits) | other;
  const std::uint64_t ends = no_digit & no_point & kHighBits;
  if (ends == 0) {
    return {};
  }
  const auto end = static_cast<unsigned>(std::countr_zero(ends)) & 0x38U;
  const std::uint64_t points = no_digit & kHighBits & ((std::uint64_t{1} << end) - 1U);
  const auto whole = static_cast<unsigned>(std::countr_zero(points | ends)) & 0x38U;
  const unsigned point_bits = whole == end ? 0U : 8U;
  const unsigned bits = end - point_bits;  // of the digits
  if (bits == 0U || (points & (points - 1U)) != 0U ||
      static_cast<char>((text >> end) | 0x20U) == 'e') {
    return {};
  }
  const std::uint64_t below = (std::uint64_t{1} << whole) - 1U;
  const std::uint64_t joined = (digit & below) | ((digit >> point_bits) & ~below);
  return {value_of_eight_digits(joined << (64U - bits)),
          (bits - whole) / 8U,
          negative,
          p + negative + end / 8U};
}

/// Any number that scan_short() leaves.
[[nodiscard]] const char* scan_other_number(const char* p, char point, double& value) noexcept;

}  // namespace decimal_detail

/// Reads the number at `p`: sign, digits, `point`, digits, exponent. Returns where it ends, or null
/// if there is no finite number; a value below the smallest double is 0. The result is the double
/// nearest to the decimal.
///
/// Fast path: with at most 2^53 as digits and a power of ten up to 22 both are exact doubles, so
/// one multiplication or division rounds once (Clinger 1990); everything else goes to
/// std::from_chars. \pre a byte that cannot belong to a number follows within the buffer, and eight
/// more after it.
[[nodiscard, gnu::always_inline]] inline const char* scan_number(const char* p,
                                                                 char point,
                                                                 double& value) noexcept {
  using namespace decimal_detail;
  const ShortNumber number = scan_short(p, point);
  if (number.end == nullptr) [[unlikely]] {
    return scan_other_number(p, point, value);
  }
  const double magnitude = static_cast<double>(static_cast<std::int64_t>(number.mantissa)) /
                           kPowersOfTen[number.decimals];
  value = std::bit_cast<double>(std::bit_cast<std::uint64_t>(magnitude) | number.negative << 63U);
  return number.end;
}

/// Reads seconds at `p` as nanoseconds: exact to nine decimals, further ones are rounded half away
/// from zero. Returns where it ends, or null if there is no time within kLongestTimeS.
/// \pre as scan_number.
[[nodiscard]] const char* scan_seconds(const char* p, char point, std::int64_t& time_ns) noexcept;

}  // namespace tcert::table
