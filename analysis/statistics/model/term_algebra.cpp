#include <statistics/model/term_algebra.hpp>

#include <algorithm>

namespace tcert::statistics {
namespace {

bool holds_term(const Terms& terms, const Term& wanted) {
  return std::any_of(
      terms.begin(), terms.end(), [&](const Term& term) { return same_term(term, wanted); });
}

void add_term(Terms& terms, const Term& term) {
  if (!holds_term(terms, term)) {
    terms.push_back(term);
  }
}

}  // namespace

bool holds(const Term& term, const Expression& variable) {
  return std::find(term.variables.begin(), term.variables.end(), variable) != term.variables.end();
}

bool same_term(const Term& a, const Term& b) {
  return a.variables.size() == b.variables.size() &&
         std::all_of(a.variables.begin(), a.variables.end(), [&](const Expression& variable) {
           return holds(b, variable);
         });
}

void remove_terms(Terms& terms, const Terms& unwanted) {
  std::erase_if(terms, [&](const Term& term) { return holds_term(unwanted, term); });
}

Term joined(const Term& a, const Term& b) {
  Term both = a;
  for (const Expression& variable : b.variables) {
    if (!holds(both, variable)) {
      both.variables.push_back(variable);
    }
  }
  return both;
}

Terms interactions(const Terms& a, const Terms& b) {
  Terms all;
  for (const Term& left : a) {
    for (const Term& right : b) {
      add_term(all, joined(left, right));
    }
  }
  return all;
}

Terms united(Terms a, const Terms& b) {
  for (const Term& term : b) {
    add_term(a, term);
  }
  return a;
}

}  // namespace tcert::statistics
