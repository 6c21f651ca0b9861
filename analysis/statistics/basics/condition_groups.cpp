#include <statistics/basics/condition_groups.hpp>

#include <algorithm>

namespace tcert::statistics {

std::vector<SharedCondition> shared_conditions(const std::vector<OwnedCondition>& conditions) {
  std::vector<SharedCondition> shared;
  for (const OwnedCondition& one : conditions) {
    const auto alike =
        std::find_if(shared.begin(), shared.end(), [&](const SharedCondition& other) {
          return other.condition.kind == one.condition.kind &&
                 other.condition.severity == one.condition.severity &&
                 other.condition.column == one.condition.column &&
                 other.condition.advice == one.condition.advice && other.of == one.of;
        });
    if (alike == shared.end()) {
      shared.push_back({{one.owner}, one.of, one.condition, true});
      continue;
    }
    alike->same_detail = alike->same_detail && alike->condition.detail == one.condition.detail;
    if (std::find(alike->owners.begin(), alike->owners.end(), one.owner) == alike->owners.end()) {
      alike->owners.push_back(one.owner);
    }
  }
  return shared;
}

std::string subject_of(const std::string& detail) {
  const auto colon = detail.find(": ");
  return colon == std::string::npos ? "" : detail.substr(0, colon);
}

std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 3;
  // One more is named sooner than counted.
  const std::size_t named = names.size() <= kNamed + 1 ? names.size() : kNamed;
  std::string text;
  for (std::size_t i = 0; i < named; ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  return named == names.size() ? text
                               : text + " and " + std::to_string(names.size() - named) + " more";
}

Conditions one_per_factor(const Conditions& conditions,
                          const std::function<std::string(const std::string&)>& factor_of) {
  std::vector<OwnedCondition> owned;
  for (const Condition& condition : conditions) {
    const std::string factor = condition.column.empty() ? "" : factor_of(condition.column);
    if (factor.empty()) {
      owned.push_back({"", condition.detail, condition});
      continue;
    }
    owned.push_back({condition.column, "", condition});
    owned.back().condition.column = factor;
  }
  Conditions result;
  for (SharedCondition& shared : shared_conditions(owned)) {
    Condition& condition = shared.condition;
    if (shared.owners.size() == 1 && !shared.owners.front().empty()) {
      condition.column = shared.owners.front();
    } else if (shared.owners.size() > 1) {
      condition.detail = std::to_string(shared.owners.size()) + " columns (" +
                         some_of(shared.owners) + ")" +
                         (condition.detail.empty() ? "" : ", the first: " + condition.detail);
    }
    result.push_back(std::move(condition));
  }
  return result;
}

}  // namespace tcert::statistics
