#include <statistics/basics/condition.hpp>

#include <algorithm>
#include <utility>

namespace tcert::statistics {

Condition error_of(ConditionKind kind, std::string column, std::string detail, std::string advice) {
  return {kind, ConditionSeverity::error, std::move(column), std::move(detail), std::move(advice)};
}

std::string_view advice(const Condition& condition) noexcept {
  return condition.advice.empty() ? advice(condition.kind) : std::string_view(condition.advice);
}

std::string_view to_string(ConditionSeverity severity) noexcept {
  switch (severity) {
    case ConditionSeverity::note:
      return "note";
    case ConditionSeverity::warning:
      return "warning";
    case ConditionSeverity::error:
      return "error";
  }
  return "";
}

std::string to_string(const Condition& condition) {
  std::string line(to_string(condition.severity));
  line += ": ";
  if (!condition.column.empty()) {
    line += "column '" + condition.column + "': ";
  }
  line += words(condition.kind);
  if (!condition.detail.empty()) {
    line += ": " + condition.detail;
  }
  if (!advice(condition).empty()) {
    line += "; ";
    line += advice(condition);
  }
  return line;
}

bool has(std::span<const Condition> conditions, ConditionKind kind) noexcept {
  return std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    return condition.kind == kind;
  });
}

bool has_error(std::span<const Condition> conditions) noexcept {
  return std::any_of(conditions.begin(), conditions.end(), [](const Condition& condition) {
    return condition.severity == ConditionSeverity::error;
  });
}

}  // namespace tcert::statistics
