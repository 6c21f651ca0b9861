#include <table/clock_column.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <table/name_words.hpp>

namespace tcert::table {
namespace {

constexpr std::array<std::string_view, 7> kClockWords = {
    "time", "t", "timestamp", "stamp", "clock", "datetime", "rosbagtimestamp"};

/// Words that may stand before the clock's own.
constexpr std::array<std::string_view, 10> kBefore = {
    "field", "header", "msg", "message", "log", "receive", "recv", "ros", "rosbag", "publish"};

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// "TimeUS" is time, us.
std::vector<std::string> clock_words(std::string_view name) {
  std::vector<std::string> words = name_words(name);
  if (!words.empty() && words.back().starts_with("time") && words.back().size() > 4) {
    const std::string unit = words.back().substr(4);
    if (time_unit_of_word(unit)) {
      words.back().resize(4);
      words.push_back(unit);
    }
  }
  return words;
}

struct ClockName {
  std::string stem;  ///< The words before the unit.
  std::optional<TimeUnit> unit;
};

std::optional<ClockName> clock_name(std::string_view name) {
  std::vector<std::string> words = clock_words(name);
  ClockName found;
  if (!words.empty()) {
    found.unit = time_unit_of_word(words.back());
  }
  const bool is_counter = words.size() == 1 && (words[0] == "millis" || words[0] == "micros");
  if (found.unit && !is_counter) {
    words.pop_back();
  }
  for (const std::string& word : words) {
    found.stem += word + ' ';
  }
  const bool is_clock = !words.empty() && (is_counter || is_one_of(words.back(), kClockWords)) &&
                        std::all_of(words.begin(), words.end() - 1, [](const std::string& word) {
                          return is_one_of(word, kBefore);
                        });
  return is_clock ? std::optional(found) : std::nullopt;
}

/// Whole seconds and nanoseconds come in two columns of one stem.
ClockColumn with_nanoseconds(const std::vector<std::string>& names,
                             std::size_t column,
                             const std::optional<ClockName>& clock) {
  ClockColumn found{column, std::nullopt, std::nullopt};
  if (!clock) {
    return found;
  }
  found.named_unit = clock->unit;
  // time_s beside time_ns is the same time twice; sec beside nanosec is one time in two parts.
  const auto ends_with_part = [](const std::string& name, std::string_view part) {
    return name_words(name).back().find(part) != std::string::npos;
  };
  if (clock->unit != TimeUnit::seconds || !ends_with_part(names[column], "sec")) {
    return found;
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto other = clock_name(names[i]);
    if (other && other->stem == clock->stem && other->unit == TimeUnit::nanoseconds &&
        ends_with_part(names[i], "sec")) {
      found.nanoseconds = i;
    }
  }
  return found;
}

}  // namespace

bool is_clock_name(std::string_view name) { return clock_name(name).has_value(); }

std::optional<ClockColumn> find_clock(const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const auto clock = clock_name(names[i])) {
      return with_nanoseconds(names, i, clock);
    }
  }
  return std::nullopt;
}

std::optional<ClockColumn> clock_named(const std::vector<std::string>& names,
                                       std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) {
    return std::nullopt;
  }
  const auto column = static_cast<std::size_t>(found - names.begin());
  return with_nanoseconds(names, column, clock_name(name));
}

}  // namespace tcert::table
