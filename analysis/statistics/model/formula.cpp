#include <statistics/model/formula.hpp>

#include <algorithm>
#include <statistics/model/formula_expansion.hpp>
#include <table/trimmed.hpp>

namespace tcert::statistics {

std::string Term::name() const {
  std::string name;
  for (const Expression& variable : variables) {
    name += (name.empty() ? "" : ":") + to_string(variable);
  }
  return name;
}

std::vector<Expression> RandomTerm::variables() const {
  std::vector<Expression> all;
  for (const Term& term : terms) {
    for (const Expression& variable : term.variables) {
      if (std::find(all.begin(), all.end(), variable) == all.end()) {
        all.push_back(variable);
      }
    }
  }
  return all;
}

std::vector<std::string> Formula::columns() const {
  std::vector<std::string> names;
  collect_columns(response, names);
  for (const Term& term : terms) {
    for (const Expression& variable : term.variables) {
      collect_columns(variable, names);
    }
  }
  for (const auto* list : {&offsets, &strata, &clusters}) {
    for (const Expression& expression : *list) {
      collect_columns(expression, names);
    }
  }
  for (const RandomTerm& random : random_terms) {
    for (const Expression& variable : random.variables()) {
      collect_columns(variable, names);
    }
    collect_columns(random.group, names);
  }
  return names;
}

Formula parse_formula(std::string_view text) {
  Formula formula;
  formula.text = table::trimmed(text);
  const Expression whole = parse_expression(formula.text);
  if (!whole.is_call("~") || whole.arguments.size() != 2) {
    throw FormulaError("formula '" + formula.text +
                       "': expected outcome ~ terms, for instance success ~ x1 + x2");
  }
  formula.response = whole.arguments[0];
  expand_right_side(whole.arguments[1], formula);
  formula.intercept = formula.intercept || formula.response.is_call("Surv");
  return formula;
}

}  // namespace tcert::statistics
