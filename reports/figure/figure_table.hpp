#pragma once
/// \file
/// Making the table of a figure. Internal to reports/figure.

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "reports/cells_by_name.hpp"
#include "reports/figure/figure.hpp"
#include "reports/table.hpp"

namespace tcert {

/// A control character of ASCII: a newline, a tab. Bytes of UTF-8 are none.
[[nodiscard]] bool is_control(char c) noexcept;

/// "95 % expanded intervals": level and method as the brackets of a column's heading have them;
/// "intervals" if it has none.
[[nodiscard]] std::string intervals_of(const Table& table, std::string_view column);

/// Different texts of a column, in the order in which they first occur.
[[nodiscard]] std::vector<std::string> distinct(const Table& table, std::string_view column);

/// Column `part`, then texts, then numbers; a number's unit is in its name.
[[nodiscard]] Table figure_table(std::string name,
                                 const std::vector<std::string>& texts,
                                 const std::vector<std::string>& numbers);

/// Empty texts and NaN are missing.
void add_figure_row(Table& table,
                    const std::string& part,
                    const std::vector<std::string>& texts,
                    const std::vector<double>& numbers);

/// Commas and quotation marks of every text in the figure become other signs: gnuplot has no CSV
/// with either in a cell. Control characters, of titles too, become spaces: gnuplot ends a comment
/// and a row at a newline.
void make_plain(Figure& figure);

/// A round step that cuts `span` into at most `parts`: 1, 2 or 5 times a power of ten.
[[nodiscard]] double round_step(double span, int parts);

/// Multiples of a round step within the range, at most `most` + 1: each is the number that its
/// label says. Empty if the range is.
[[nodiscard]] std::vector<double> round_ticks(double low, double high, int most);

/// Ticks of a scale of ratios that a span of this kind needs.
[[nodiscard]] std::vector<double> ratio_ticks(double low, double high);

}  // namespace tcert
