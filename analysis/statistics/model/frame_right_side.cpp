#include <algorithm>
#include <cstdint>
#include <iterator>
#include <statistics/model/factor_levels.hpp>
#include <statistics/model/frame_checks.hpp>
#include <statistics/model/frame_parts.hpp>
#include <utility>

namespace tcert::statistics {
namespace {

constexpr std::size_t kMostGroups = 1000;  ///< A curve each; a test is cubic in their number.

void keep_rows(std::vector<NamedVariable>& variables, bool allow_infinite, ModelFrame& frame) {
  for (NamedVariable& variable : variables) {
    Variable& value = variable.value;
    if (value.kind == Variable::Kind::factor) {
      value.factor = on_rows(value.factor, frame.rows);
      continue;
    }
    if (frame.dropped > 0) {
      value.numbers = on_rows(value.numbers, frame.rows);
      for (std::vector<double>& column : value.basis) {
        column = on_rows(column, frame.rows);
      }
    }
    const std::string name = to_string(variable.expression);
    const bool said = std::any_of(frame.conditions.begin(),
                                  frame.conditions.end(),
                                  [&](const Condition& one) { return one.column == name; });
    if (!allow_infinite && !said) {
      check_finite(value.numbers, name, frame);
    }
  }
}

bool has_products_with_strata(const EvaluatedFormula& all) {
  return std::any_of(all.right.begin(), all.right.end(), [](const NamedVariable& variable) {
    return variable.expression.is_call("strata");
  });
}

/// Products with strata() are coded as if its own effects were in the model; these have no
/// columns, as in coxph().
DesignMatrix design_within_strata(const EvaluatedFormula& all, std::size_t rows) {
  if (!has_products_with_strata(all)) {
    return design_matrix(all.formula, all.right, rows);
  }
  Formula whole = all.formula;
  std::copy_if(
      all.formula.strata_effects.begin(),
      all.formula.strata_effects.end(),
      std::back_inserter(whole.terms),
      [&](const Term& effect) { return has_variable(all.right, effect.variables.front()); });
  const DesignMatrix with_effects = design_matrix(whole, all.right, rows);
  DesignMatrix design;
  std::vector<Eigen::Index> kept;
  for (std::size_t k = 0; k < with_effects.columns.size(); ++k) {
    if (with_effects.term_of[k] <= all.formula.terms.size()) {
      kept.push_back(static_cast<Eigen::Index>(k));
      design.columns.push_back(with_effects.columns[k]);
      design.term_of.push_back(with_effects.term_of[k]);
    }
  }
  design.values = with_effects.values(Eigen::all, kept);
  return design;
}

void take_design(const EvaluatedFormula& all, ModelFrame& frame) {
  DesignMatrix design = design_within_strata(all, frame.size());
  frame.design = std::move(design.values);
  frame.columns = std::move(design.columns);
  frame.term_of = std::move(design.term_of);
}

void take_groups(const EvaluatedFormula& all, ModelFrame& frame) {
  const std::string formula = "formula '" + all.formula.text + "': ";
  if (has_products_with_strata(all)) {
    throw FormulaError(formula + "a product with strata() is for cox; here write + strata()");
  }
  std::vector<table::Factor> factors;
  for (const NamedVariable& variable : all.right) {
    factors.push_back(evaluate_factor(variable.expression, all.table));
    name_levels(factors.back(), to_string(variable.expression));
  }
  if (factors.empty()) {
    frame.groups = table::Factor{std::vector<std::uint32_t>(frame.size(), 0), {"all"}};
  } else {
    frame.groups = on_rows(crossed(factors, ", "), frame.rows);
  }
  if (frame.groups->levels.size() > kMostGroups) {
    throw FormulaError(formula + std::to_string(frame.groups->levels.size()) +
                       " groups to compare, at most " + std::to_string(kMostGroups) +
                       "; did you mean cox?");
  }
}

}  // namespace

void take_right_side(EvaluatedFormula& all, ModelFrame& frame) {
  keep_rows(all.right, all.options.allow_infinite, frame);
  for (const Term& term : all.formula.terms) {
    frame.terms.push_back(term.name());
  }
  if (all.options.right_side == RightSide::groups) {
    take_groups(all, frame);
  } else {
    take_design(all, frame);
  }
}

void take_random_effects(EvaluatedFormula& all, ModelFrame& frame) {
  keep_rows(all.slopes, all.options.allow_infinite, frame);
  for (std::size_t k = 0; k < all.groups.size(); ++k) {
    Formula effects;
    effects.intercept = all.formula.random_terms[k].intercept;
    effects.terms = all.formula.random_terms[k].terms;
    DesignMatrix design = design_matrix(effects, all.slopes, frame.size());
    frame.random_effects.push_back({to_string(all.groups[k].expression),
                                    on_rows(all.groups[k].value.factor, frame.rows),
                                    std::move(design.values),
                                    std::move(design.columns)});
  }
}

void take_strata(const EvaluatedFormula& all, ModelFrame& frame) {
  if (all.strata.empty()) {
    return;
  }
  std::vector<table::Factor> factors;
  for (const NamedVariable& variable : all.strata) {
    factors.push_back(variable.value.factor);
    if (!all.strata_are_text || all.strata.size() > 1) {
      name_levels(factors.back(), to_string(variable.expression));
    }
  }
  frame.strata = on_rows(crossed(factors, ", "), frame.rows);
}

}  // namespace tcert::statistics
