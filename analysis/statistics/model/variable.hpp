#pragma once
/// \file
/// The value of an expression on every row of a table.

#include <map>
#include <statistics/model/expression.hpp>
#include <string>
#include <table/data_table.hpp>
#include <table/factor.hpp>
#include <vector>

namespace tcert::statistics {

/// Numbers (NaN is missing), truth values (numbers that are 0 or 1: comparisons, and columns of
/// TRUE and FALSE), a factor, or a basis: several columns of numbers, of ns() and poly().
struct Variable {
  enum class Kind { number, truth, factor, basis };

  Kind kind = Kind::number;
  std::vector<double> numbers;               ///< Of a number or a truth value.
  table::Factor factor;                      ///< Of a factor.
  std::vector<std::vector<double>> basis{};  ///< Of a basis; `numbers` is then its first column.

  [[nodiscard]] bool is_missing(std::size_t row) const noexcept {
    return kind == Kind::factor ? factor.codes[row] == table::Factor::kMissing
                                : numbers[row] != numbers[row];
  }
};

/// Reference level by column: it becomes the first level.
using References = std::map<std::string, std::string>;

/// \throws FormulaError with the nearest name if there is no such column.
[[nodiscard]] const table::DataColumn& named_column(const table::DataTable& table,
                                                    const std::string& name);

/// Arithmetic (+ - * / ^), comparison, & | ! %in%, log (with a base), log2, log10, log1p, exp,
/// sqrt, sin, cos, tan, abs, pmin, pmax, ifelse, cut, ns, poly, I, scale, factor, strata and
/// as.numeric. A text column is a factor; factor() of numbers sorts its levels by value, and
/// numbers that print alike to 15 digits are one level, as in R. TRUE and FALSE (after == and
/// != also T and F) are truth values where no column has that name. strata() is the cross of its
/// arguments, its levels named as survival names them. scale() uses the mean and standard deviation
/// (n - 1) of the rows where its argument is known, as R does before it leaves rows out. A truth
/// value as a factor has the levels FALSE and TRUE. O(rows) a call, O(rows log levels) for a
/// factor. \throws FormulaError if a column is not there (with the nearest name), a function is not
/// known, or an argument is of the wrong kind.
[[nodiscard]] Variable evaluate(const Expression& expression,
                                const table::DataTable& table,
                                const References& references = {});

/// The same as a factor: numbers become levels by value.
[[nodiscard]] table::Factor evaluate_factor(const Expression& expression,
                                            const table::DataTable& table);

}  // namespace tcert::statistics
