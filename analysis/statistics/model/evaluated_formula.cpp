#include <statistics/model/evaluated_formula.hpp>

#include <algorithm>
#include <statistics/model/stray_text.hpp>

namespace tcert::statistics {
namespace {

Expression column_named(const std::string& name) {
  return {Expression::Kind::column, 0.0, name, {}};
}

/// The column in which an expression of names has them: x, (x) and I(x) of x.
const Expression& inside(const Expression& expression) {
  const bool wraps =
      (expression.is_call("(") || expression.is_call("I")) && expression.arguments.size() == 1;
  return wraps ? inside(expression.arguments.front()) : expression;
}

/// Stray texts would otherwise make a factor of a column of numbers.
void refuse_stray_text(const EvaluatedFormula& all, const Expression& expression) {
  const table::DataColumn* const column = text_column(expression, all.table);
  if (all.options.right_side == RightSide::groups) {
    refuse_missing_words(all.table, column);
  } else if (column != nullptr && column->mixed.is_spoiled()) {
    throw FormulaError(stray_cell(all.table, *column) + "; write factor(" + column->name +
                       ") if it is a name");
  }
}

NamedVariable evaluated(const EvaluatedFormula& all, const Expression& expression) {
  return {expression, evaluate(expression, all.table, all.options.reference)};
}

NamedVariable evaluated_numbers(const EvaluatedFormula& all, const Expression& expression) {
  NamedVariable variable = evaluated(all, expression);
  if (variable.value.kind == Variable::Kind::factor) {
    throw FormulaError(not_numbers(all.table, to_string(expression)));
  }
  return variable;
}

NamedVariable evaluated_names(const EvaluatedFormula& all, const Expression& expression) {
  refuse_missing_words(all.table, text_column(expression, all.table));
  return {expression, {Variable::Kind::factor, {}, evaluate_factor(expression, all.table)}};
}

void add_predictor(const EvaluatedFormula& all,
                   const Expression& expression,
                   std::vector<NamedVariable>& list) {
  if (!has_variable(list, expression)) {
    refuse_stray_text(all, expression);
    list.push_back(evaluated(all, expression));
  }
}

void add_outcome(const Expression& response, EvaluatedFormula& all) {
  if (!response.is_call("Surv") && !response.is_call("cbind")) {
    all.outcome.push_back(evaluated(all, response));
    return;
  }
  for (const Expression& argument : response.arguments) {
    // Of times, counts and a status only the status may be a factor.
    const bool is_status = response.is_call("Surv") && &argument == &response.arguments.back();
    all.outcome.push_back(is_status ? evaluated(all, argument) : evaluated_numbers(all, argument));
  }
}

void add_strata(EvaluatedFormula& all) {
  for (const Expression& strata : all.formula.strata) {
    all.strata_are_text =
        all.strata_are_text && evaluate(strata, all.table).kind == Variable::Kind::factor;
    all.strata.push_back(evaluated_names(all, strata));
  }
  if (!all.options.strata.empty()) {
    all.strata.push_back(evaluated_names(all, column_named(all.options.strata)));
  }
}

void add_clusters(EvaluatedFormula& all) {
  std::vector<Expression> clusters = all.formula.clusters;
  if (!all.options.cluster.empty()) {
    clusters.push_back(column_named(all.options.cluster));
  }
  if (clusters.size() > 1) {
    throw FormulaError("formula '" + all.formula.text + "': one cluster at the most");
  }
  for (const Expression& cluster : clusters) {
    all.clusters.push_back(evaluated_names(all, cluster));
  }
}

}  // namespace

EvaluatedFormula evaluate_formula(const Formula& formula,
                                  const table::DataTable& table,
                                  const FrameOptions& options) {
  EvaluatedFormula all{formula, table, options, {}, {}, {}, {}, {}, {}, {}, {}};
  add_outcome(formula.response, all);
  for (const Term& term : formula.terms) {
    for (const Expression& expression : term.variables) {
      add_predictor(all, expression, all.right);
    }
  }
  for (const Expression& offset : formula.offsets) {
    all.offsets.push_back(evaluated_numbers(all, offset));
  }
  add_strata(all);
  add_clusters(all);
  for (const RandomTerm& random : formula.random_terms) {
    all.groups.push_back(evaluated_names(all, random.group));
    for (const Expression& expression : random.variables()) {
      add_predictor(all, expression, all.slopes);
    }
  }
  if (!options.weights.empty()) {
    all.weights.push_back(evaluated_numbers(all, column_named(options.weights)));
  }
  return all;
}

bool has_variable(const std::vector<NamedVariable>& variables, const Expression& expression) {
  return std::any_of(variables.begin(), variables.end(), [&](const NamedVariable& one) {
    return one.expression == expression;
  });
}

const table::DataColumn* text_column(const Expression& expression, const table::DataTable& table) {
  const Expression& name = inside(expression);
  const table::DataColumn* const column =
      name.kind == Expression::Kind::column ? table.find(name.name) : nullptr;
  return column != nullptr && column->is_text ? column : nullptr;
}

}  // namespace tcert::statistics
