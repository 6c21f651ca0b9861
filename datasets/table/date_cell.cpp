#include <table/date_cell.hpp>

#include <chrono>
#include <table/decimal.hpp>
#include <table/text_steps.hpp>
#include <utility>

namespace tcert::table {
namespace {

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
  const auto date = std::chrono::year(first) / month / day;
  if (first < 1970 || first > 2096 || !date.ok()) {
    return false;
  }
  days = std::chrono::sys_days(date).time_since_epoch().count();
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
  const std::int64_t whole_s = days * 86400 + (hours * 3600 + minutes * 60 + seconds);
  time_ns = whole_s * 1'000'000'000 + fraction_ns;
  while (rest.starts_with(' ')) {
    rest.remove_prefix(1);
  }
  return take_offset(rest, time_ns) && rest.empty();
}

}  // namespace tcert::table
