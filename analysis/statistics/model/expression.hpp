#pragma once
/// \file
/// An expression of R's formula language: numbers, texts, columns, calls.

#include <stdexcept>
#include <string>
#include <string_view>
#include <table/printable.hpp>
#include <vector>

namespace tcert::statistics {

/// A column has no arguments; operators are calls named by their sign, parentheses one named "(".
struct Expression {
  enum class Kind { number, text, column, call };

  Kind kind = Kind::number;
  double value = 0.0;                 ///< Of a number.
  std::string name;                   ///< Of a column or a call ("log", "+", "=="); a text itself.
  std::vector<Expression> arguments;  ///< Of a call.

  friend bool operator==(const Expression&, const Expression&) = default;

  [[nodiscard]] bool is_call(std::string_view function) const noexcept {
    return kind == Kind::call && name == function;
  }
};

/// As R prints it: "I(x^2)", "log(x, base = 2)", "status == 2", "`a name`".
[[nodiscard]] std::string to_string(const Expression& expression);

/// Appends the names of the columns that it uses, each once, in order of appearance.
void collect_columns(const Expression& expression, std::vector<std::string>& names);

/// What is wrong with a formula; `what()` is one line and names the place.
class FormulaError : public std::invalid_argument {
 public:
  explicit FormulaError(const std::string& message)
      : std::invalid_argument(table::printable(message)) {}
};

/// Parses with R's precedence: ^, unary -, :, %in%, * /, + -, comparison, !, &, | and ||, ~. A
/// named argument is a call of "=" with the name as a text. Names that are not syntactic stand
/// between backticks, texts between quotes. \throws FormulaError.
[[nodiscard]] Expression parse_expression(std::string_view text);

}  // namespace tcert::statistics
