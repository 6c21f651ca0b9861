#include <statistics/model/formula_expansion.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <statistics/model/term_algebra.hpp>
#include <string>
#include <utility>

namespace tcert::statistics {
namespace {

/// Turns a side into terms; what is no term goes into the formula itself.
class Expansion {
 public:
  explicit Expansion(Formula& formula) : formula_(formula) {}

  Terms terms_of(const Expression& side) {
    if (side.kind == Expression::Kind::number) {
      take_intercept(side, true);
      return {};
    }
    if (side.kind != Expression::Kind::call) {
      return variable(side);
    }
    if (side.name == "(") {
      return in_parentheses(side);
    }
    if (side.arguments.size() == 2) {
      if (side.name == "+") {
        Terms left = terms_of(side.arguments[0]);
        return united(std::move(left), terms_of(side.arguments[1]));
      }
      if (side.name == "-") {
        return difference(side);
      }
      if (side.name == "*" || side.name == ":" || side.name == "/") {
        return product(side);
      }
      if (side.name == "^") {
        return power(side);
      }
    }
    if (side.arguments.size() == 1 && (side.name == "+" || side.name == "-")) {
      return signed_term(side);
    }
    return special_or_variable(side);
  }

  /// Every variable, in the order in which the text names them.
  [[nodiscard]] const std::vector<Expression>& seen() const noexcept { return seen_; }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw FormulaError("formula '" + formula_.text + "': " + problem);
  }

  void take_intercept(const Expression& number, bool added) {
    if (number.value != 0.0 && number.value != 1.0) {
      fail("a number on the right-hand side is 0 or 1; arithmetic goes into I()");
    }
    formula_.intercept = (number.value == 1.0) == added;
  }

  Terms in_parentheses(const Expression& group) {
    const Expression& inside = group.arguments.front();
    if (!inside.is_call("|") && !inside.is_call("||")) {
      return terms_of(inside);
    }
    const RandomTerm effects = random_effects(inside.arguments.front());
    for (const Expression& level : nested_groups(inside.arguments.back())) {
      take_random_term(effects, inside.is_call("||"), level);
    }
    return {};
  }

  /// The left side of a bar, without its group.
  [[nodiscard]] RandomTerm random_effects(const Expression& side) const;

  /// a/b: a and b:a.
  static std::vector<Expression> nested_groups(const Expression& group) {
    if (!group.is_call("/")) {
      return {group};
    }
    std::vector<Expression> groups = nested_groups(group.arguments[0]);
    groups.push_back({Expression::Kind::call, 0.0, ":", {group.arguments[1], groups.back()}});
    return groups;
  }

  void take_random_term(const RandomTerm& effects, bool uncorrelated, const Expression& group) {
    if (!uncorrelated) {
      formula_.random_terms.push_back({effects.intercept, effects.terms, group});
      return;
    }
    if (effects.intercept) {
      formula_.random_terms.push_back({true, {}, group});
    }
    for (const Term& term : effects.terms) {
      formula_.random_terms.push_back({false, {term}, group});
    }
  }

  Terms difference(const Expression& side) {
    Terms left = terms_of(side.arguments[0]);
    const Expression& right = side.arguments[1];
    if (right.kind == Expression::Kind::number) {
      take_intercept(right, false);
      return left;
    }
    remove_terms(left, terms_of(right));
    return left;
  }

  Terms signed_term(const Expression& side) {
    const Expression& term = side.arguments[0];
    if (term.kind == Expression::Kind::number) {
      take_intercept(term, side.name == "+");
      return {};
    }
    if (side.name == "-") {
      fail("nothing to take '" + to_string(term) + "' from; for -x write I(-x)");
    }
    return terms_of(term);
  }

  Terms product(const Expression& side) {
    const Terms left = terms_of(side.arguments[0]);
    const Terms right = terms_of(side.arguments[1]);
    if (left.empty() || right.empty()) {
      fail("'" + to_string(side) + "' is no product of terms; arithmetic goes into I()");
    }
    if (side.name == ":") {
      return interactions(left, right);
    }
    if (side.name == "*") {
      return united(united(left, right), interactions(left, right));
    }
    Term all;
    for (const Term& term : left) {
      all = joined(all, term);
    }
    return united(left, interactions({all}, right));
  }

  Terms power(const Expression& side) {
    const Expression& exponent = side.arguments[1];
    const bool whole = exponent.kind == Expression::Kind::number &&
                       exponent.value == std::floor(exponent.value) && exponent.value >= 1.0 &&
                       exponent.value <= 8.0;
    if (!whole) {
      fail("a power of terms is a whole number up to 8; arithmetic goes into I()");
    }
    const Terms base = terms_of(side.arguments[0]);
    Terms all = base;
    for (int i = 1; i < static_cast<int>(exponent.value); ++i) {
      all = united(all, interactions(all, base));
    }
    return all;
  }

  Terms special_or_variable(const Expression& call) {
    if (call.name == "offset" || call.name == "cluster") {
      if (call.arguments.size() != 1) {
        fail(call.name + "() takes one argument");
      }
      (call.name == "offset" ? formula_.offsets : formula_.clusters)
          .push_back(call.arguments.front());
      return {};
    }
    if (call.name == "Surv" || call.name == "cbind" || call.name == "~" || call.name == "|" ||
        call.name == "||") {
      fail("'" + to_string(call) + "' cannot stand on the right-hand side");
    }
    return variable(call);
  }

  Terms variable(const Expression& expression) {
    if (std::find(seen_.begin(), seen_.end(), expression) == seen_.end()) {
      seen_.push_back(expression);
    }
    return {Term{{expression}}};
  }

  Formula& formula_;
  std::vector<Expression> seen_;
};

/// Variables within a term by first appearance in the formula; terms by order.
void sort_as_r_does(Terms& terms, const std::vector<Expression>& seen) {
  const auto place = [&](const Expression& variable) {
    return std::find(seen.begin(), seen.end(), variable);
  };
  for (Term& term : terms) {
    std::sort(term.variables.begin(),
              term.variables.end(),
              [&](const Expression& a, const Expression& b) { return place(a) < place(b); });
  }
  std::stable_sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) {
    return a.variables.size() < b.variables.size();
  });
}

RandomTerm Expansion::random_effects(const Expression& side) const {
  Formula own;
  own.text = formula_.text;
  Expansion expansion(own);
  RandomTerm effects;
  effects.terms = expansion.terms_of(side);
  const bool plain = own.offsets.empty() && own.clusters.empty() && own.random_terms.empty() &&
                     std::none_of(expansion.seen().begin(),
                                  expansion.seen().end(),
                                  [](const Expression& one) { return one.is_call("strata"); });
  if (!plain || (effects.terms.empty() && !own.intercept)) {
    fail("'" + to_string(side) + "' are no random effects: write (1 | group) or (1 + x | group)");
  }
  effects.intercept = own.intercept;
  sort_as_r_does(effects.terms, expansion.seen());
  return effects;
}

/// Strata are no columns of the model: their own effects leave the terms.
void move_strata(const std::vector<Expression>& seen, Formula& formula) {
  for (const Expression& variable : seen) {
    const bool used = variable.is_call("strata") &&
                      std::any_of(formula.terms.begin(),
                                  formula.terms.end(),
                                  [&](const Term& term) { return holds(term, variable); });
    for (const Expression& argument : variable.arguments) {
      if (used && std::find(formula.strata.begin(), formula.strata.end(), argument) ==
                      formula.strata.end()) {
        formula.strata.push_back(argument);
      }
    }
  }
  const auto is_stratum = [](const Term& term) {
    return term.variables.size() == 1 && term.variables.front().is_call("strata");
  };
  std::copy_if(formula.terms.begin(),
               formula.terms.end(),
               std::back_inserter(formula.strata_effects),
               is_stratum);
  std::erase_if(formula.terms, is_stratum);
}

}  // namespace

void expand_right_side(const Expression& side, Formula& formula) {
  Expansion expansion(formula);
  formula.terms = expansion.terms_of(side);
  sort_as_r_does(formula.terms, expansion.seen());
  move_strata(expansion.seen(), formula);
}

}  // namespace tcert::statistics
