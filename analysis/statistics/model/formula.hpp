#pragma once
/// \file
/// R's model formulas, the subset that the estimators here take.
///
///     success ~ x1 + x2:lighting + a*b + I(x^2) + log(x) + scale(x) + factor(day) + offset(o)
///     cbind(k, n - k) ~ factor(period) + (1 | herd)
///     success ~ x1 + (1 + x1 | day) + (1 | run:day)
///     Surv(time, status == 2) ~ age + strata(sex) + cluster(inst)
///     Surv(start, stop, event) ~ x
///
/// `+ 0` and `- 1` drop the intercept, but not of Surv(): a Cox model has none to drop, and its
/// factors keep their contrasts as coxph's do. x * strata(g) is x and x:strata(g) within strata.
/// `- term` drops a term, `a/b` is a + a:b, `(a + b)^2` all terms of
/// up to two variables. There is no `.` and no `%in%`. `(1 | a/b)` is (1 | a) + (1 | b:a), and
/// `(1 + x || g)` is (1 | g) + (0 + x | g).

#include <cstddef>
#include <statistics/model/expression.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::statistics {

/// One term of the right-hand side: variables joined by ':'.
struct Term {
  std::vector<Expression> variables;  ///< By their first appearance in the formula.

  [[nodiscard]] std::string name() const;  ///< "x1:lighting".
};

/// True if they hold the same variables, in any order.
[[nodiscard]] bool same_term(const Term& a, const Term& b);

/// Effects that vary at random between the levels of a factor, correlated within a level:
/// (1 + x | group).
struct RandomTerm {
  bool intercept = true;
  std::vector<Term> terms;  ///< As the formula's own.
  Expression group;

  [[nodiscard]] std::vector<Expression> variables() const;  ///< Of the terms, each once.
};

struct Formula {
  std::string text;  ///< As given, outer blanks removed.
  Expression response;
  bool intercept = true;
  std::vector<Term> terms;           ///< Main effects first, then by order, as R sorts them.
  std::vector<Expression> offsets;   ///< Arguments of offset().
  std::vector<Expression> strata;    ///< Arguments of strata(), also of those in products.
  std::vector<Term> strata_effects;  ///< strata() on its own: it has no coefficients, but x *
                                     ///< strata(g) is coded against it.
  std::vector<Expression> clusters;  ///< Arguments of cluster().
  std::vector<RandomTerm> random_terms;

  /// Names of all columns that it uses, each once, in order of appearance.
  [[nodiscard]] std::vector<std::string> columns() const;
};

/// \throws FormulaError.
[[nodiscard]] Formula parse_formula(std::string_view text);

}  // namespace tcert::statistics
