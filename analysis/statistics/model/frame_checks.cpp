#include <statistics/model/frame_checks.hpp>

#include <cmath>
#include <statistics/survival/time_conditions.hpp>
#include <table/csv_write.hpp>
#include <table/unlike_times.hpp>

namespace tcert::statistics {

std::string place_of(const ModelFrame& frame, std::size_t i) {
  std::string place = "row " + std::to_string(frame.rows[i] + 1);
  if (i < frame.lines.size()) {
    place += " (line " + std::to_string(frame.lines[i]) + ")";
  }
  return place;
}

namespace {

/// Adds an error if `is_bad(i)` holds for some row; `found(i)` says what stands there.
template <class IsBad, class Found>
void check_rows(ModelFrame& frame,
                ConditionKind kind,
                const std::string& column,
                const IsBad& is_bad,
                const Found& found) {
  std::size_t bad = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    if (is_bad(i)) {
      first = bad++ == 0 ? i : first;
    }
  }
  if (bad == 0) {
    return;
  }
  std::string detail = "found " + found(first) + " in " + place_of(frame, first);
  if (bad > 1) {
    detail += " (and " + std::to_string(bad - 1) + " more)";
  }
  frame.conditions.push_back({kind, ConditionSeverity::error, column, std::move(detail)});
}

std::string text(double value) {
  if (std::isinf(value)) {
    return value > 0 ? "Inf" : "-Inf";
  }
  return table::number_text(value);
}

}  // namespace

void add_missing_conditions(ModelFrame& frame) {
  if (frame.dropped > 0) {
    std::string columns;
    std::string detail;
    for (const auto& [name, count] : frame.missing) {
      columns += (columns.empty() ? "" : ", ") + name;
      detail += (detail.empty() ? "" : ", ") + name + " in " + std::to_string(count);
    }
    frame.conditions.push_back({ConditionKind::missing_rows,
                                ConditionSeverity::note,
                                std::move(columns),
                                std::to_string(frame.dropped) + " of " +
                                    std::to_string(frame.dropped + frame.size()) + " (" + detail +
                                    ")"});
  }
  if (frame.size() == 0) {
    frame.conditions.push_back({ConditionKind::no_rows,
                                ConditionSeverity::error,
                                "",
                                frame.dropped == 0 ? "the table has a header and no rows" : ""});
  }
}

void check_finite(const std::vector<double>& values, const std::string& column, ModelFrame& frame) {
  check_rows(
      frame,
      ConditionKind::infinite_value,
      column,
      [&](std::size_t i) { return !std::isfinite(values[i]); },
      [&](std::size_t i) { return text(values[i]); });
}

void check_binary(const std::vector<double>& values, const std::string& column, ModelFrame& frame) {
  check_rows(
      frame,
      ConditionKind::not_binary,
      column,
      [&](std::size_t i) { return values[i] != 0.0 && values[i] != 1.0; },
      [&](std::size_t i) { return text(values[i]); });
}

void check_weights(const std::vector<double>& values,
                   const std::string& column,
                   ModelFrame& frame) {
  check_rows(
      frame,
      ConditionKind::bad_weight,
      column,
      [&](std::size_t i) { return !(std::isfinite(values[i]) && values[i] > 0.0); },
      [&](std::size_t i) { return text(values[i]); });
}

void check_times(const SurvivalOutcome& survival, const std::string& column, ModelFrame& frame) {
  check_rows(
      frame,
      ConditionKind::infinite_value,
      column,
      [&](std::size_t i) {
        return !std::isfinite(survival.stop[i]) ||
               (survival.left_truncated() && !std::isfinite(survival.start[i]));
      },
      [&](std::size_t i) { return text(survival.stop[i]); });
  check_rows(
      frame,
      ConditionKind::time_not_positive,
      column,
      [&](std::size_t i) { return !(survival.stop[i] > 0.0); },
      [&](std::size_t i) { return text(survival.stop[i]); });
  if (survival.left_truncated()) {
    check_rows(
        frame,
        ConditionKind::start_not_before_stop,
        column,
        [&](std::size_t i) { return !(survival.start[i] < survival.stop[i]); },
        [&](std::size_t i) {
          return "start " + text(survival.start[i]) + ", stop " + text(survival.stop[i]);
        });
  }
}

void round_and_check_times(SurvivalOutcome& survival,
                           const std::string& column,
                           bool round,
                           ModelFrame& frame) {
  // With (start, stop] stamps may be the clock that all trials share.
  if (!survival.left_truncated() || !table::are_stamps(survival.stop)) {
    add_unlike_times(
        survival.stop, column, [&](std::size_t i) { return place_of(frame, i); }, frame.conditions);
  }
  if (!round) {
    add_rounding_conditions(count_times(survival), column, frame.conditions);
    return;
  }
  add_rounding_conditions(round_times(survival), column, frame.conditions);
  if (survival.left_truncated()) {
    check_rows(
        frame,
        ConditionKind::start_not_before_stop,
        column,
        [&](std::size_t i) { return !(survival.start[i] < survival.stop[i]); },
        [&](std::size_t i) {
          return "a step of rounding size at " + text(survival.stop[i]) +
                 "; subtract the first time from both, or keep it with --no-time-rounding";
        });
  }
}

void check_counts(ModelFrame& frame) {
  const auto& counts = std::get<CountOutcome>(frame.outcome);
  const auto is_count = [](double x) { return std::isfinite(x) && x >= 0.0 && x == std::floor(x); };
  check_rows(
      frame,
      ConditionKind::bad_counts,
      frame.response,
      [&](std::size_t i) {
        return !is_count(counts.successes[i]) || !is_count(counts.trials[i] - counts.successes[i]);
      },
      [&](std::size_t i) { return text(counts.successes[i]) + " of " + text(counts.trials[i]); });
}

}  // namespace tcert::statistics
