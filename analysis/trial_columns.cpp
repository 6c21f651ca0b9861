#include "analysis/trial_columns.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "datasets/csv_write.hpp"
#include "datasets/nearest_name.hpp"
#include "datasets/trial_table.hpp"

namespace tcert {
namespace {

template <auto kMember>
constexpr TrialColumn text_column(std::string_view name) {
  return {name,
          "a text",
          [](std::string& out, const TrialRow& trial) { append_text(out, trial.*kMember); },
          [](TrialRow& trial, std::string_view cell) {
            trial.*kMember = cell;
            return true;
          }};
}

template <auto kMember>
constexpr TrialColumn number_column(std::string_view name) {
  return {name,
          "a number or an empty cell",
          [](std::string& out, const TrialRow& trial) {
            if (trial.*kMember) {
              append_number(out, *(trial.*kMember));
            }
          },
          [](TrialRow& trial, std::string_view cell) { return read_number(cell, trial.*kMember); }};
}

constexpr std::array kEndReasons{EndReason::unknown,
                                 EndReason::goal,
                                 EndReason::collision,
                                 EndReason::wedged,
                                 EndReason::timeout,
                                 EndReason::aborted};

void append_end_reason(std::string& out, const TrialRow& trial) {
  out += to_string(trial.end_reason);
}

bool read_end_reason(TrialRow& trial, std::string_view cell) {
  const std::string_view name = is_missing(cell) ? std::string_view() : cell;
  const auto* found = std::find_if(kEndReasons.begin(), kEndReasons.end(), [&](EndReason reason) {
    return to_string(reason) == name;
  });
  if (found == kEndReasons.end()) {
    return false;
  }
  trial.end_reason = *found;
  return true;
}

void append_success(std::string& out, const TrialRow& trial) {
  if (trial.success) {
    out += *trial.success ? '1' : '0';
  }
}

bool read_success(TrialRow& trial, std::string_view cell) {
  trial.success.reset();
  const std::string word = case_folded(cell);
  if (word == "1" || word == "true") {
    trial.success = true;
  } else if (word == "0" || word == "false") {
    trial.success = false;
  }
  return trial.success || is_missing(cell);
}

constexpr std::array<TrialColumn, 9> kColumns{
    text_column<&TrialRow::trial_id>("trial_id"),
    text_column<&TrialRow::algorithm>("algorithm"),
    text_column<&TrialRow::lighting>("lighting"),
    text_column<&TrialRow::day>("day"),
    text_column<&TrialRow::batch>("batch"),
    TrialColumn{"success", "0, 1, true, false or an empty cell", append_success, read_success},
    number_column<&TrialRow::time_s>("time_s"),
    number_column<&TrialRow::distance_m>("distance_m"),
    TrialColumn{"end_reason",
                "goal, collision, wedged, timeout, aborted or an empty cell",
                append_end_reason,
                read_end_reason}};

}  // namespace

const std::array<TrialColumn, 9>& trial_columns() noexcept { return kColumns; }

bool read_number(std::string_view cell, std::optional<double>& value) noexcept {
  value.reset();
  if (is_missing(cell)) {
    return true;
  }
  double number = 0.0;
  const char* const end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(number)) {
    return false;
  }
  value = number;
  return true;
}

}  // namespace tcert
