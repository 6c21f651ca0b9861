#pragma once
/// \file
/// Cells and columns that the reports of fits have in common, named as R's broom names them.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <string>
#include <vector>

#include "reports/table.hpp"

namespace tcert {

/// Digits that people see of a coefficient or a statistic.
inline constexpr int kShownDigits = 4;

[[nodiscard]] TableCell text_cell(const std::optional<std::string>& text);
[[nodiscard]] TableCell integer_cell(const std::optional<std::int64_t>& value);
[[nodiscard]] TableCell number_cell(const std::optional<double>& value);
[[nodiscard]] TableCell p_cell(const std::optional<double>& value);
[[nodiscard]] TableCell low_cell(const std::optional<statistics::Interval>& interval);
[[nodiscard]] TableCell high_cell(const std::optional<statistics::Interval>& interval);

/// The value with its interval, if there is one; missing without a value.
[[nodiscard]] TableCell estimate_cell(const std::optional<double>& value,
                                      const std::optional<statistics::Interval>& interval);
/// part / whole; missing of nothing.
[[nodiscard]] std::optional<double> share(std::size_t part, std::size_t whole);
/// Missing otherwise.
template <class Value>
[[nodiscard]] std::optional<Value> when(bool condition, const Value& value) {
  return condition ? std::optional(value) : std::nullopt;
}
/// Missing if there are no words.
[[nodiscard]] std::optional<std::string> not_empty(std::string text);

/// "yes", "no" or missing.
[[nodiscard]] TableCell yes_or_no_cell(const std::optional<bool>& answer);

[[nodiscard]] Column text_column(std::string name, std::string heading);
[[nodiscard]] Column integer_column(std::string name, std::string heading);
/// Printed with kShownDigits significant digits.
[[nodiscard]] Column number_column(std::string name, std::string heading);
/// Of times: printed with 15 significant digits, so that what is read off finds its step again.
[[nodiscard]] Column time_column(std::string name, std::string heading);
/// Printed with a fixed number of decimals, 3 unless another is said: a value, a value with its
/// interval.
[[nodiscard]] Column fixed_column(std::string name, std::string heading);
[[nodiscard]] Column estimate_column(std::string name, std::string heading);
[[nodiscard]] Column fixed_column(std::string name,
                                  std::string heading,
                                  std::string unit,
                                  int decimals = 3);
[[nodiscard]] Column p_column(std::string name, std::string heading);

/// A table of one row, made column by column.
class Record {
 public:
  Record(std::string name, std::string title);

  Record& text(std::string name, std::string heading, std::string value);
  Record& integer(std::string name, std::string heading, std::size_t value);
  Record& number(std::string name, std::string heading, const std::optional<double>& value);
  Record& p(std::string name, std::string heading, const std::optional<double>& value);

  [[nodiscard]] Table table() &&;

 private:
  Table table_;
  std::vector<TableCell> cells_;
};

}  // namespace tcert
