#include <algorithm>
#include <cmath>
#include <statistics/model/frame_checks.hpp>
#include <statistics/model/frame_parts.hpp>

namespace tcert::statistics {
namespace {

void mark_missing(const NamedVariable& variable, std::vector<bool>& complete, ModelFrame& frame) {
  std::size_t missing = 0;
  for (std::size_t row = 0; row < complete.size(); ++row) {
    if (variable.value.is_missing(row)) {
      complete[row] = false;
      ++missing;
    }
  }
  if (missing > 0) {
    frame.missing.emplace_back(to_string(variable.expression), missing);
  }
}

bool may_have_undefined_products(const EvaluatedFormula& all) {
  const auto is_product = [](const Term& term) { return term.variables.size() > 1; };
  const auto has_infinity = [](const NamedVariable& variable) {
    const std::vector<double>& x = variable.value.numbers;
    return std::any_of(x.begin(), x.end(), [](double one) { return std::isinf(one); });
  };
  return std::any_of(all.formula.terms.begin(), all.formula.terms.end(), is_product) &&
         std::any_of(all.right.begin(), all.right.end(), has_infinity);
}

/// Infinity times 0 within a term is missing.
void mark_undefined_products(const EvaluatedFormula& all,
                             std::vector<bool>& complete,
                             ModelFrame& frame) {
  const DesignMatrix design = design_matrix(all.formula, all.right, complete.size());
  for (std::size_t t = 0; t < all.formula.terms.size(); ++t) {
    std::size_t undefined = 0;
    for (std::size_t row = 0; row < complete.size(); ++row) {
      bool is_undefined = false;
      for (std::size_t k = 0; complete[row] && k < design.term_of.size(); ++k) {
        is_undefined = is_undefined || (design.term_of[k] == t + 1 &&
                                        std::isnan(design.values(static_cast<Eigen::Index>(row),
                                                                 static_cast<Eigen::Index>(k))));
      }
      if (is_undefined) {
        complete[row] = false;
        ++undefined;
      }
    }
    if (undefined > 0) {
      frame.missing.emplace_back(all.formula.terms[t].name(), undefined);
    }
  }
}

}  // namespace

void take_rows(const EvaluatedFormula& all, ModelFrame& frame) {
  std::vector<bool> complete(all.table.rows, true);
  for (const auto* list : {&all.outcome,
                           &all.offsets,
                           &all.strata,
                           &all.clusters,
                           &all.groups,
                           &all.weights,
                           &all.right,
                           &all.slopes}) {
    for (const NamedVariable& variable : *list) {
      // Of a product with strata() its arguments are marked, one by one.
      if (list != &all.right || !variable.expression.is_call("strata")) {
        mark_missing(variable, complete, frame);
      }
    }
  }
  if (all.options.allow_infinite && all.options.right_side == RightSide::design &&
      may_have_undefined_products(all)) {
    mark_undefined_products(all, complete, frame);
  }
  const auto kept = static_cast<std::size_t>(std::count(complete.begin(), complete.end(), true));
  frame.rows.reserve(kept);
  frame.lines.reserve(all.table.lines.empty() ? 0 : kept);
  for (std::size_t row = 0; row < complete.size(); ++row) {
    if (complete[row]) {
      frame.rows.push_back(row);
      if (!all.table.lines.empty()) {
        frame.lines.push_back(all.table.lines[row]);
      }
    }
  }
  frame.dropped = complete.size() - frame.rows.size();
  add_missing_conditions(frame);
}

std::vector<double> on_rows(const std::vector<double>& numbers,
                            const std::vector<std::size_t>& rows) {
  std::vector<double> kept;
  kept.reserve(rows.size());
  for (const std::size_t row : rows) {
    kept.push_back(numbers[row]);
  }
  return kept;
}

}  // namespace tcert::statistics
