#include <statistics/model/droppable_terms.hpp>

#include <algorithm>
#include <string_view>

namespace tcert::statistics {
namespace {

/// The variables of a term: parts between colons that no parenthesis encloses, sorted.
std::vector<std::string> variables_of(std::string_view term) {
  std::vector<std::string> variables(1);
  int depth = 0;
  for (const char c : term) {
    depth += (c == '(' ? 1 : 0) - (c == ')' ? 1 : 0);
    if (c == ':' && depth == 0) {
      variables.emplace_back();
    } else {
      variables.back() += c;
    }
  }
  std::sort(variables.begin(), variables.end());
  return variables;
}

bool is_contained(const std::vector<std::string>& terms, std::size_t term) {
  const std::vector<std::string> small = variables_of(terms[term]);
  return std::any_of(terms.begin(), terms.end(), [&](const std::string& other) {
    const std::vector<std::string> large = variables_of(other);
    return large.size() > small.size() &&
           std::includes(large.begin(), large.end(), small.begin(), small.end());
  });
}

}  // namespace

std::vector<std::size_t> droppable_terms(const std::vector<std::string>& terms) {
  std::vector<std::size_t> droppable;
  for (std::size_t term = 0; term < terms.size(); ++term) {
    if (!is_contained(terms, term)) {
      droppable.push_back(term);
    }
  }
  return droppable;
}

}  // namespace tcert::statistics
