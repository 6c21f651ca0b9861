#include <table/decimal.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <system_error>

namespace tcert::table {

namespace decimal_detail {

const char* scan_exponent(const char* p, int& exponent) noexcept {
  const char* digit = p + 1;
  const bool negative = *digit == '-';
  digit += (negative || *digit == '+') ? 1 : 0;
  if (!is_digit(*digit)) {
    return p;
  }
  constexpr int kBeyondAnyDouble = 100'000;
  int power = 0;
  for (; is_digit(*digit); ++digit) {
    power = std::min(kBeyondAnyDouble, power * 10 + (*digit - '0'));
  }
  exponent += negative ? -power : power;
  return digit;
}

const char* scan_long_number(const char* begin,
                             const char* end,
                             char point,
                             double& value) noexcept {
  const char* first = *begin == '+' ? begin + 1 : begin;
  std::string with_point;
  if (point != '.') {
    with_point.assign(first, end);
    std::ranges::replace(with_point, point, '.');
    first = with_point.data();
  }
  const char* const last = point == '.' ? end : first + with_point.size();
  const auto [stop, error] = std::from_chars(first, last, value);
  if (error == std::errc{}) {
    return stop == last ? end : nullptr;
  }
  if (error != std::errc::result_out_of_range) {
    return nullptr;
  }
  // from_chars does not say on which side it left the range. Below it, the value is zero.
  const bool negative = *first == '-';
  // scan() reads eight bytes at once, and a cell of its own may end before.
  std::string padded(negative ? first + 1 : first, last);
  padded.append(sizeof(std::uint64_t), '\0');
  const Digits digits = scan(padded.data(), '.');
  if (digits.exponent + digits.count > 0) {
    return nullptr;
  }
  value = negative ? -0.0 : 0.0;
  return end;
}

const char* scan_other_number(const char* p, char point, double& value) noexcept {
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

}  // namespace decimal_detail

namespace {

using decimal_detail::Digits;
using decimal_detail::is_digit;

constexpr std::uint64_t kLongestTimeNs = std::uint64_t{kLongestTimeS} * 1'000'000'000;

/// Of the last of so many decimals.
constexpr std::array<std::uint64_t, 10> kNanosecondsOfDecimal{
    1'000'000'000, 100'000'000, 10'000'000, 1'000'000, 100'000, 10'000, 1'000, 100, 10, 1};

/// The first 19 significant digits, and the one after them.
struct LeadingDigits {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  int next = 0;
};

LeadingDigits leading_digits(const char* p, const Digits& digits) noexcept {
  LeadingDigits leading{0, digits.exponent, 0};
  int kept = 0;
  for (std::int64_t seen = 0; seen < digits.count; ++p) {
    if (!is_digit(*p)) {
      continue;
    }
    ++seen;
    const int digit = *p - '0';
    if (kept < 19) {
      leading.mantissa = leading.mantissa * 10U + static_cast<std::uint64_t>(digit);
      kept += (kept > 0 || digit != 0) ? 1 : 0;
    } else {
      leading.next = kept == 19 ? digit : leading.next;
      ++kept;
      ++leading.exponent;
    }
  }
  return leading;
}

/// Nearest integer to digits x 10^power, half away from zero; above kLongestTimeNs if too large.
std::uint64_t scaled(const LeadingDigits& digits, int power) noexcept {
  std::uint64_t sum = digits.mantissa;
  if (sum < std::uint64_t{1} << 32U && power >= 0 && power < 10) {
    return sum * kNanosecondsOfDecimal[static_cast<std::size_t>(9 - power)];
  }
  for (; power > 0 && sum != 0 && sum <= kLongestTimeNs; --power) {
    sum = sum > kLongestTimeNs / 10U ? kLongestTimeNs + 1U : sum * 10U;
  }
  auto below = static_cast<std::uint64_t>(digits.next);
  for (; power < 0 && (sum != 0 || below != 0); ++power) {
    below = sum % 10U;
    sum /= 10U;
  }
  return sum + (power == 0 && below >= 5U ? 1U : 0U);
}

}  // namespace

const char* scan_seconds(const char* p, char point, std::int64_t& time_ns) noexcept {
  if (const auto number = decimal_detail::scan_short(p, point); number.end != nullptr) {
    const auto time =
        static_cast<std::int64_t>(number.mantissa * kNanosecondsOfDecimal[number.decimals]);
    time_ns = number.negative != 0 ? -time : time;
    return number.end;
  }
  const bool negative = *p == '-';
  p += (negative || *p == '+') ? 1 : 0;
  const Digits digits = decimal_detail::scan(p, point);
  if (digits.end == nullptr) {
    return nullptr;
  }
  const LeadingDigits leading = digits.count <= 19
                                    ? LeadingDigits{digits.mantissa, digits.exponent, 0}
                                    : leading_digits(p, digits);
  const std::uint64_t magnitude = scaled(leading, leading.exponent + 9);
  if (magnitude > kLongestTimeNs) {
    return nullptr;
  }
  const auto time = static_cast<std::int64_t>(magnitude);
  time_ns = negative ? -time : time;
  return digits.end;
}

}  // namespace tcert::table
