#include <statistics/survival/time_conditions.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <table/csv_write.hpp>
#include <table/unlike_times.hpp>

namespace tcert::statistics {
namespace {

/// Of a time: what a few additions lose is no more.
constexpr double kLastDigits = 1e-12;

std::string short_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

}  // namespace

void add_rounding_conditions(const TimeRounding& rounding,
                             const std::string& column,
                             Conditions& conditions) {
  if (rounding.by_timefix < rounding.kept) {
    conditions.push_back({ConditionKind::near_times,
                          ConditionSeverity::note,
                          column,
                          std::to_string(rounding.kept) +
                              " distinct times, of which those within " +
                              short_number(rounding.timefix_step) + " of a neighbour would leave " +
                              std::to_string(rounding.by_timefix)});
  }
  if (rounding.merged_share > kLastDigits) {
    conditions.push_back({ConditionKind::merged_times,
                          ConditionSeverity::note,
                          column,
                          std::to_string(rounding.distinct) + " distinct times, some within " +
                              short_number(rounding.merged_step) + " of each other, were made " +
                              std::to_string(rounding.kept)});
  }
}

void add_unlike_times(std::span<const double> times,
                      const std::string& column,
                      const std::function<std::string(std::size_t)>& place,
                      Conditions& conditions) {
  if (table::are_stamps(times)) {
    const auto [least, largest] = std::minmax_element(times.begin(), times.end());
    std::string range = "from ";
    table::append_number(range, *least);
    range += " to ";
    table::append_number(range, *largest);
    conditions.push_back(
        {ConditionKind::stamped_times, ConditionSeverity::warning, column, std::move(range)});
    return;
  }
  const auto unlike = table::unlike_times(times);
  if (!unlike) {
    return;
  }
  std::string found = "found ";
  table::append_number(found, unlike->time);
  found += ", " + table::distance_in_words(*unlike) + "; the first in " + place(unlike->first);
  if (unlike->count > 1) {
    found += " (and " + std::to_string(unlike->count - 1) + " more)";
  }
  conditions.push_back(
      {ConditionKind::unlike_times, ConditionSeverity::warning, column, std::move(found)});
}

}  // namespace tcert::statistics
