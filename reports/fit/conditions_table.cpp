#include <algorithm>
#include <statistics/basics/condition_groups.hpp>
#include <string>
#include <vector>

#include "reports/columns_of.hpp"
#include "reports/fit/fit_report.hpp"
#include "reports/text_width.hpp"

namespace tcert {
namespace {

/// Conditions of one kind and severity for which the same is to be done.
struct Shared {
  statistics::Condition first;
  std::vector<std::string> columns;
  std::vector<std::string> details;
};

void add_once(const std::string& text, std::vector<std::string>& list) {
  if (!text.empty() && std::find(list.begin(), list.end(), text) == list.end()) {
    list.push_back(text);
  }
}

std::vector<Shared> shared(const statistics::Conditions& conditions) {
  std::vector<Shared> all;
  for (const statistics::Condition& one : conditions) {
    auto found = std::find_if(all.begin(), all.end(), [&](const Shared& other) {
      return other.first.kind == one.kind && other.first.severity == one.severity &&
             advice(other.first) == advice(one);
    });
    if (found == all.end()) {
      found = all.insert(all.end(), {one, {}, {}});
    }
    add_once(one.column, found->columns);
    add_once(one.detail, found->details);
  }
  return all;
}

/// The first few, and how many more.
std::string some(const std::vector<std::string>& details) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, details.size()); ++i) {
    text += (i == 0 ? "" : "; ") + details[i];
  }
  return details.size() <= kShown
             ? text
             : text + "; and " + std::to_string(details.size() - kShown) + " more";
}

}  // namespace

Table all_conditions_table(const statistics::Conditions& conditions) {
  using statistics::Condition;
  return ColumnsOf<Condition>()
      .text("severity", "", [](auto& one) { return std::string(to_string(one.severity)); })
      .text("condition", "condition", [](auto& one) { return std::string(words(one.kind)); })
      .text("column", "column", &Condition::column)
      .text("detail", "found", &Condition::detail)
      .text("advice", "what to do", [](auto& one) { return std::string(advice(one)); })
      .table("conditions", "Conditions", conditions);
}

Table conditions_table(const statistics::Conditions& conditions) {
  return ColumnsOf<Shared>()
      .text("severity", "", [](auto& one) { return std::string(to_string(one.first.severity)); })
      .text("condition", "condition", [](auto& one) { return std::string(words(one.first.kind)); })
      .text("column", "column", [](auto& one) { return statistics::some_of(one.columns); })
      .text("detail", "found", [](auto& one) { return some(one.details); })
      .text("advice", "what to do", [](auto& one) { return std::string(advice(one.first)); })
      .table("conditions", "Conditions", shared(conditions));
}

std::string conditions_text(const statistics::Conditions& conditions, std::size_t width) {
  std::string text;
  for (const Shared& one : shared(conditions)) {
    text += std::string(to_string(one.first.severity)) + ": " + std::string(words(one.first.kind)) +
            (one.columns.empty() ? "" : " (" + statistics::some_of(one.columns) + ")");
    const std::string details = some(one.details);
    text += details.empty() ? "" : ": " + details;
    const std::string_view advised = advice(one.first);
    text += advised.empty() ? "" : "; " + std::string(advised);
    text += ".\n";
  }
  return wrapped(text, width);
}

}  // namespace tcert
