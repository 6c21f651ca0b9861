#include <table/time_unit.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <table/bytes.hpp>
#include <table/decimal.hpp>
#include <table/nearest_name.hpp>
#include <table/text_steps.hpp>
#include <utility>
#include <vector>

namespace tcert::table {
namespace {

struct UnitWord {
  std::string_view word;
  TimeUnit unit;
};

constexpr std::array kUnitWords{UnitWord{"s", TimeUnit::seconds},
                                UnitWord{"sec", TimeUnit::seconds},
                                UnitWord{"secs", TimeUnit::seconds},
                                UnitWord{"second", TimeUnit::seconds},
                                UnitWord{"seconds", TimeUnit::seconds},
                                UnitWord{"ms", TimeUnit::milliseconds},
                                UnitWord{"msec", TimeUnit::milliseconds},
                                UnitWord{"msecs", TimeUnit::milliseconds},
                                UnitWord{"millis", TimeUnit::milliseconds},
                                UnitWord{"milliseconds", TimeUnit::milliseconds},
                                UnitWord{"us", TimeUnit::microseconds},
                                UnitWord{"usec", TimeUnit::microseconds},
                                UnitWord{"usecs", TimeUnit::microseconds},
                                UnitWord{"micros", TimeUnit::microseconds},
                                UnitWord{"microseconds", TimeUnit::microseconds},
                                UnitWord{"\u00b5s", TimeUnit::microseconds},
                                UnitWord{"ns", TimeUnit::nanoseconds},
                                UnitWord{"nsec", TimeUnit::nanoseconds},
                                UnitWord{"nsecs", TimeUnit::nanoseconds},
                                UnitWord{"nanos", TimeUnit::nanoseconds},
                                UnitWord{"nanosec", TimeUnit::nanoseconds},
                                UnitWord{"nanosecs", TimeUnit::nanoseconds},
                                UnitWord{"nanoseconds", TimeUnit::nanoseconds}};

/// The unit of a stamp since 1970: 2001 to 2096 in one of the four.
std::optional<TimeUnit> unit_of_stamp(double time) noexcept {
  constexpr double kLeast = 1e9;
  constexpr double kMost = 4e9;
  for (const TimeUnit unit :
       {TimeUnit::seconds, TimeUnit::milliseconds, TimeUnit::microseconds, TimeUnit::nanoseconds}) {
    const double seconds = time * seconds_in(unit);
    if (seconds >= kLeast && seconds <= kMost) {
      return unit;
    }
  }
  return std::nullopt;
}

double median_step(std::span<const double> times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > times[i - 1]) {
      steps.push_back(times[i] - times[i - 1]);
    }
  }
  if (steps.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// The unit in which whole steps have the rate of a robot's log, nearest to 30 Hz.
TimeUnit unit_of_step(double step) noexcept {
  TimeUnit best = TimeUnit::seconds;
  double least = std::numeric_limits<double>::infinity();
  for (const TimeUnit unit :
       {TimeUnit::milliseconds, TimeUnit::microseconds, TimeUnit::nanoseconds}) {
    const double away = std::abs(std::log(30.0 * step * seconds_in(unit)));
    if (away < least) {
      least = away;
      best = unit;
    }
  }
  return best;
}

bool is_whole(double value) noexcept { return value == std::floor(value); }

}  // namespace

std::string_view name_of(TimeUnit unit) noexcept {
  switch (unit) {
    case TimeUnit::milliseconds:
      return "ms";
    case TimeUnit::microseconds:
      return "us";
    case TimeUnit::nanoseconds:
      return "ns";
    case TimeUnit::seconds:
      break;
  }
  return "s";
}

std::optional<TimeUnit> time_unit_of_word(std::string_view word) noexcept {
  const auto is_word = [&](const UnitWord& known) {
    return std::equal(
        known.word.begin(), known.word.end(), word.begin(), word.end(), [](char a, char b) {
          return a == (b >= 'A' && b <= 'Z' ? b + 32 : b);
        });
  };
  const auto* const found = std::ranges::find_if(kUnitWords, is_word);
  return found == kUnitWords.end() ? std::nullopt : std::optional(found->unit);
}

double seconds_in(TimeUnit unit) noexcept {
  switch (unit) {
    case TimeUnit::milliseconds:
      return 1e-3;
    case TimeUnit::microseconds:
      return 1e-6;
    case TimeUnit::nanoseconds:
      return 1e-9;
    case TimeUnit::seconds:
      break;
  }
  return 1.0;
}

TimeUnitGuess guess_time_unit(std::optional<TimeUnit> named, std::span<const double> times) {
  const TimeUnit said = named.value_or(TimeUnit::seconds);
  if (times.empty()) {
    return {said, ""};
  }
  constexpr double kLongestS = 4e9;
  const bool is_possible = std::abs(times.front()) * seconds_in(said) <= kLongestS;
  if (named && is_possible) {
    return {said, ""};
  }
  if (const auto stamp = unit_of_stamp(times.front())) {
    const bool agrees = *stamp == said && (named || said == TimeUnit::seconds);
    return {*stamp, agrees ? "" : "stamps since 1970 in " + std::string(name_of(*stamp))};
  }
  constexpr double kLongestStepS = 1.0;
  const double step = median_step(times);
  if (!named && std::ranges::all_of(times, is_whole) && step > kLongestStepS) {
    const TimeUnit unit = unit_of_step(step);
    return {unit, "whole numbers with steps as of " + std::string(name_of(unit))};
  }
  return {said, ""};
}

bool read_time(std::string_view cell, TimeUnit unit, char decimal_point, std::int64_t& time_ns) {
  if (cell.empty()) {
    return false;
  }
  // The exponent moves the point, so that the decimal reader rounds once.
  constexpr std::array<int, 4> kExponents{0, -3, -6, -9};
  std::string text(cell);
  const int shift = kExponents[static_cast<std::size_t>(unit)];
  if (shift != 0) {
    const std::size_t mark = text.find_first_of("eE");
    int exponent = shift;
    if (mark != std::string::npos) {
      int written = 0;
      std::string_view digits = std::string_view(text).substr(mark + 1);
      const bool negative = digits.starts_with('-');
      take_one_of(digits, "+-");
      if (!take_number(digits, 1, 3, written) || !digits.empty()) {
        return false;
      }
      exponent += negative ? -written : written;
      text.resize(mark);
    }
    text += 'e' + std::to_string(exponent);
  }
  const Bytes padded = Bytes::copy_of(text);
  const char* const begin = padded.view().data();
  return scan_seconds(begin, decimal_point, time_ns) == begin + text.size();
}

}  // namespace tcert::table
