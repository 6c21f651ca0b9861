#pragma once
/// \file
/// The arguments of a call by name and place, as R matches them. Internal to variable.cpp.

#include <cstdint>
#include <optional>
#include <statistics/model/expression.hpp>
#include <string>
#include <vector>

namespace tcert::statistics {

/// The number that an expression is, with its sign, infinity as Inf; empty for anything else.
[[nodiscard]] std::optional<double> constant_of(const Expression& expression);

class CallArguments {
 public:
  /// `names` in their order; those of the call without a name take the first places that are left.
  /// \throws FormulaError for a name that is not among them, and for too many.
  CallArguments(const Expression& call, std::vector<std::string> names);

  /// Null without one.
  [[nodiscard]] const Expression* find(const std::string& name) const noexcept;
  /// \throws FormulaError without one.
  [[nodiscard]] const Expression& required(const std::string& name) const;
  /// A whole number from 1 to 1000. \throws FormulaError for another.
  [[nodiscard]] std::optional<std::int64_t> whole(const std::string& name) const;
  /// A number or c() of them; empty without one. \throws FormulaError for anything else.
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const;
  /// TRUE or FALSE. \throws FormulaError for anything else.
  [[nodiscard]] bool truth(const std::string& name, bool usual) const;

 private:
  [[noreturn]] void fail(const std::string& problem) const;

  std::string text_;
  std::vector<std::string> names_;
  std::vector<const Expression*> values_;
};

}  // namespace tcert::statistics
