#include <table/date_cell.hpp>

#include <table/decimal.hpp>
#include <table/text_steps.hpp>
#include <utility>

namespace tcert::table {
namespace {

/// Days since 1970-01-01 in the Gregorian calendar (H. Hinnant, "chrono-compatible low-level date
/// algorithms").
std::int64_t days_since_1970(int year, int month, int day) noexcept {
  const std::int64_t y = month <= 2 ? year - 1 : year;
  const std::int64_t era = y / 400;
  const std::int64_t year_of_era = y - era * 400;
  const std::int64_t day_of_year = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year -
         719468;
}

/// ISO order, or the order of the United States and, where the first number is above 12, of Europe.
bool take_day(std::string_view& rest, std::int64_t& days) noexcept {
  int first = 0;
  int month = 0;
  int day = 0;
  std::string_view start = rest;
  if (take_number(rest, 4, 4, first) && take_one_of(rest, "-/")) {
    if (!take_number(rest, 1, 2, month) || !take_one_of(rest, "-/") ||
        !take_number(rest, 1, 2, day)) {
      return false;
    }
  } else {
    rest = start;
    int year = 0;
    if (!take_number(rest, 1, 2, month) || !take_one_of(rest, "/.") ||
        !take_number(rest, 1, 2, day) || !take_one_of(rest, "/.") ||
        !take_number(rest, 4, 4, year)) {
      return false;
    }
    if (month > 12) {
      std::swap(month, day);
    }
    first = year;
  }
  if (first < 1970 || first > 2096 || month < 1 || month > 12 || day < 1 || day > 31) {
    return false;
  }
  days = days_since_1970(first, month, day);
  return true;
}

bool take_fraction(std::string_view& rest, std::int64_t& time_ns) noexcept {
  std::int64_t scale = 1'000'000'000;
  std::size_t count = 0;
  for (; count < rest.size() && decimal_detail::is_digit(rest[count]); ++count) {
    scale /= 10;
    time_ns += (rest[count] - '0') * scale;
  }
  rest.remove_prefix(count);
  return count > 0;
}

bool take_offset(std::string_view& rest, std::int64_t& time_ns) noexcept {
  if (rest.empty() || take_one_of(rest, "Zz")) {
    return true;
  }
  const std::int64_t sign = rest.front() == '-' ? -1 : 1;
  int hours = 0;
  int minutes = 0;
  if (!take_one_of(rest, "+-") || !take_number(rest, 2, 2, hours)) {
    return false;
  }
  take_one_of(rest, ":");
  if (!rest.empty() && !take_number(rest, 2, 2, minutes)) {
    return false;
  }
  time_ns -= sign * (hours * 3600 + minutes * 60) * std::int64_t{1'000'000'000};
  return hours < 24 && minutes < 60;
}

}  // namespace

bool read_date(std::string_view cell, std::int64_t& time_ns) {
  std::string_view rest = cell;
  while (!rest.empty() && rest.front() == ' ') {
    rest.remove_prefix(1);
  }
  std::int64_t days = 0;
  int hours = 0;
  int minutes = 0;
  int seconds = 0;
  if (!take_day(rest, days) || !take_one_of(rest, "Tt ") || !take_number(rest, 1, 2, hours) ||
      !take_one_of(rest, ":") || !take_number(rest, 2, 2, minutes) || hours > 24 || minutes > 59) {
    return false;
  }
  std::int64_t fraction_ns = 0;
  if (take_one_of(rest, ":")) {
    if (!take_number(rest, 2, 2, seconds) || seconds > 60) {
      return false;
    }
    if (take_one_of(rest, ".,") && !take_fraction(rest, fraction_ns)) {
      return false;
    }
  }
  const std::int64_t whole_s = days * 86400 + hours * 3600 + minutes * 60 + seconds;
  time_ns = whole_s * 1'000'000'000 + fraction_ns;
  while (rest.starts_with(' ')) {
    rest.remove_prefix(1);
  }
  return take_offset(rest, time_ns) && rest.empty();
}

}  // namespace tcert::table
