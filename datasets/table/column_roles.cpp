#include <table/column_roles.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <table/name_words.hpp>
#include <table/nearest_name.hpp>

namespace tcert::table {
namespace {

/// Columns that only a table of trials has: its times do not follow one another.
constexpr std::array<std::string_view, 8> kTrialNames = {
    "success", "status", "event", "outcome", "trial_id", "collided", "timeout", "end_reason"};

/// Parts of the names of a sensor's columns.
constexpr std::array<std::string_view, 7> kStreamParts = {
    "x_m", "y_m", "yaw", "bend", "force", "fsr", "range"};

/// Words of the names of such columns as other programs have them.
constexpr std::array<std::string_view, 9> kStreamWords = {
    "x", "y", "z", "theta", "heading", "position", "orientation", "linear", "angular"};

/// Parts of the names of a table's columns of times, beside those of a clock.
constexpr std::array<std::string_view, 4> kTimeParts = {"time", "stamp", "duration", "elapsed"};

bool holds_part(const std::string& lower, std::span<const std::string_view> parts) {
  return std::ranges::any_of(
      parts, [&](std::string_view part) { return lower.find(part) != std::string::npos; });
}

bool is_time_name(const std::string& lower) {
  return is_clock_name(lower) || holds_part(lower, kTimeParts);
}

}  // namespace

ColumnRoles column_roles(const std::vector<std::string>& names, const std::string& clock) {
  ColumnRoles roles;
  roles.clock = clock.empty() ? find_clock(names) : clock_named(names, clock);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name = case_folded(names[i]);
    if (is_time_name(name)) {
      roles.times.push_back(i);
    }
    roles.of_trials = roles.of_trials || std::ranges::find(kTrialNames, name) != kTrialNames.end();
    const std::vector<std::string> words = name_words(name);
    roles.of_stream = roles.of_stream || holds_part(name, kStreamParts);
    roles.may_be_stream =
        roles.may_be_stream || std::ranges::any_of(words, [](const std::string& word) {
          return std::ranges::find(kStreamWords, word) != kStreamWords.end();
        });
  }
  return roles;
}

}  // namespace tcert::table
