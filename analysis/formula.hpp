#pragma once
/// \file
/// R's model formulas, the subset that the estimators here take.
///
///     success ~ x1 + x2:lighting + a*b + I(x^2) + log(x) + scale(x) + factor(day) + offset(o)
///     cbind(k, n - k) ~ factor(period) + (1 | herd)
///     Surv(time, status == 2) ~ age + strata(sex) + cluster(inst)
///     Surv(start, stop, event) ~ x
///
/// `+ 0`, `- 1` drop the intercept, `- term` drops a term, (a + b)^2 and `a %in% b` are not taken.

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tcert {

/// A number, a column or a call in a formula. A column has no arguments; operators are calls named
/// by their sign.
struct Expression {
  enum class Kind { number, column, call };

  Kind kind = Kind::number;
  double value = 0.0;                 ///< Of a number.
  std::string name;                   ///< Of a column or a call: "log", "+", "==".
  std::vector<Expression> arguments;  ///< Of a call.

  friend bool operator==(const Expression&, const Expression&) = default;
};

/// As R prints it: "I(x^2)", "log(x)", "status == 2".
[[nodiscard]] std::string to_string(const Expression& expression);

/// One term of the right-hand side: variables joined by ':'.
struct Term {
  std::vector<Expression> variables;  ///< In the order in which the formula names them.

  [[nodiscard]] std::string name() const;  ///< "x1:lighting".
};

struct Formula {
  std::string text;  ///< As given, outer blanks removed.
  Expression response;
  bool intercept = true;
  std::vector<Term> terms;                ///< By order (main effects first), then as they stand.
  std::vector<Expression> offsets;        ///< Arguments of offset().
  std::vector<Expression> strata;         ///< Arguments of strata().
  std::vector<Expression> clusters;       ///< Arguments of cluster().
  std::vector<Expression> random_groups;  ///< g of each (1 | g); a nested a/b gives a and a:b.

  /// Names of all columns that it uses, each once, in order of appearance.
  [[nodiscard]] std::vector<std::string> columns() const;
};

/// What is wrong with a formula; `what()` shows it with a caret under the place.
class FormulaError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// \throws FormulaError.
[[nodiscard]] Formula parse_formula(std::string_view text);

}  // namespace tcert
