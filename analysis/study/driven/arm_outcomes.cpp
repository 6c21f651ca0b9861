#include "analysis/study/driven/arm_outcomes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <table/not_a_number.hpp>

namespace tcert::study {
namespace {

std::optional<std::size_t> place_of(const std::vector<std::string>& columns,
                                    const std::string& name) {
  const auto found = std::ranges::find(columns, name);
  return found == columns.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - columns.begin()));
}

double number_in(const TrialRow& row, std::optional<std::size_t> place) {
  double value = table::kNaN;
  if (place && *place < row.extra.size()) {
    const std::string& cell = row.extra[*place];
    const auto [rest, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || rest != cell.data() + cell.size()) {
      return table::kNaN;
    }
  }
  return value;
}

}  // namespace

OutcomesByArm outcomes_by_arm(const std::vector<TrialRow>& trials,
                              const std::vector<std::string>& extra_columns,
                              const std::string& pair) {
  const auto pair_column = place_of(extra_columns, pair);
  if (!pair_column) {
    throw std::invalid_argument("trials.csv has no column '" + pair +
                                "', which says what two trials have in common");
  }
  const auto peak = place_of(extra_columns, "peak_force_n");
  const auto above = place_of(extra_columns, "time_above_force_s");
  const auto stalls = place_of(extra_columns, "stalls");
  OutcomesByArm found;
  for (const TrialRow& row : trials) {
    found.unknown += row.success ? 0 : 1;
    if (!row.success || *pair_column >= row.extra.size()) {
      continue;
    }
    const std::string arm = row.algorithm;
    const auto [of_arm, is_new] = found.of.try_emplace(arm);
    if (is_new) {
      found.arms.push_back(arm);
    }
    std::string name = row.extra[*pair_column];
    name += ' ';
    name += row.lighting;
    const bool added = of_arm->second
                           .emplace(name,
                                    ArmOutcome{name,
                                               row.day,
                                               *row.success,
                                               row.end_reason,
                                               row.distance_m.value_or(table::kNaN),
                                               row.time_s.value_or(table::kNaN),
                                               number_in(row, peak),
                                               number_in(row, above),
                                               number_in(row, stalls)})
                           .second;
    if (!added) {
      throw std::invalid_argument(fmt::format("'{}' has two trials in {} {}", arm, pair, name));
    }
  }
  return found;
}

}  // namespace tcert::study
