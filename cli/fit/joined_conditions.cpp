#include "cli/fit/joined_conditions.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace tcert::cli {
namespace {

constexpr std::size_t kMostLines = 3;
constexpr std::size_t kMostNames = 8;

/// The term that a condition's column is of; empty for another column.
std::string term_of(const ModelFrame& frame, const Condition& condition) {
  const auto found = std::find(frame.columns.begin(), frame.columns.end(), condition.column);
  if (found == frame.columns.end()) {
    return {};
  }
  const std::size_t term = frame.term_of[static_cast<std::size_t>(found - frame.columns.begin())];
  return term == 0 ? std::string() : frame.terms[term - 1];
}

std::string detail_of(const std::vector<const Condition*>& same) {
  std::string detail = std::to_string(same.size()) + " columns: ";
  for (std::size_t k = 0; k < std::min(kMostNames, same.size()); ++k) {
    detail += (k == 0 ? "" : ", ") + same[k]->column;
  }
  if (same.size() > kMostNames) {
    detail += " and " + std::to_string(same.size() - kMostNames) + " more";
  }
  return same.front()->detail.empty() ? detail : detail + "; of the first: " + same.front()->detail;
}

}  // namespace

Conditions joined(const ModelFrame& frame, const Conditions& conditions) {
  std::vector<std::string> terms;
  terms.reserve(conditions.size());
  for (const Condition& one : conditions) {
    terms.push_back(term_of(frame, one));
  }
  Conditions result;
  std::vector<bool> taken(conditions.size(), false);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (taken[i]) {
      continue;
    }
    std::vector<std::size_t> like{i};
    for (std::size_t j = i + 1; j < conditions.size() && !terms[i].empty(); ++j) {
      const bool same = terms[j] == terms[i] && conditions[j].kind == conditions[i].kind &&
                        conditions[j].severity == conditions[i].severity &&
                        conditions[j].advice == conditions[i].advice;
      if (same) {
        like.push_back(j);
      }
    }
    if (like.size() <= kMostLines) {
      result.push_back(conditions[i]);
      continue;
    }
    std::vector<const Condition*> same;
    for (const std::size_t j : like) {
      taken[j] = true;
      same.push_back(&conditions[j]);
    }
    Condition one = conditions[i];
    one.column = terms[i];
    one.detail = detail_of(same);
    result.push_back(one);
  }
  return result;
}

}  // namespace tcert::cli
