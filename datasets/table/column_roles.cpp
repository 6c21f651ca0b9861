#include <table/column_roles.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

namespace tcert::table {
namespace {

constexpr std::array<std::string_view, 6> kClockNames = {
    "time", "time_s", "t", "t_s", "timestamp", "stamp"};

/// Columns that only a table of trials has: its times do not follow one another.
constexpr std::array<std::string_view, 8> kTrialNames = {
    "success", "status", "event", "outcome", "trial_id", "collided", "timeout", "end_reason"};

/// Parts of the names of a sensor's columns.
constexpr std::array<std::string_view, 7> kStreamParts = {
    "x_m", "y_m", "yaw", "bend", "force", "fsr", "range"};

/// Parts of the names of a table's columns of times, beside those of a clock.
constexpr std::array<std::string_view, 4> kTimeParts = {"time", "stamp", "duration", "elapsed"};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

bool holds_part(const std::string& lower, std::span<const std::string_view> parts) {
  return std::ranges::any_of(
      parts, [&](std::string_view part) { return lower.find(part) != std::string::npos; });
}

bool is_clock_name(const std::string& lower) {
  return std::ranges::find(kClockNames, lower) != kClockNames.end();
}

bool is_time_name(const std::string& lower) {
  return is_clock_name(lower) || holds_part(lower, kTimeParts);
}

}  // namespace

ColumnRoles column_roles(const std::vector<std::string>& names) {
  ColumnRoles roles;
  roles.clock = names.size();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = lower_case(names[i]);
    if (is_clock_name(name) && roles.clock == names.size()) {
      roles.clock = i;
    }
    if (is_time_name(name)) {
      roles.times.push_back(i);
    }
    roles.of_trials = roles.of_trials || std::ranges::find(kTrialNames, name) != kTrialNames.end();
    roles.of_stream = roles.of_stream || holds_part(name, kStreamParts);
  }
  return roles;
}

}  // namespace tcert::table
