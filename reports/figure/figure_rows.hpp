#pragma once
/// \file
/// Which rows of a figure's table its layers draw. Internal to reports/figure.

#include <cstddef>
#include <string>
#include <vector>

#include "reports/figure/figure.hpp"

namespace tcert {

/// True if the row is one of the layer's, of the class if one is named; its numbers may be missing.
[[nodiscard]] bool is_of(const Figure& figure,
                         const Panel& panel,
                         const Layer& layer,
                         std::size_t row,
                         const std::string& class_name = "");

/// Rows that the layer draws: every column that it needs is there. In the order of the table.
[[nodiscard]] std::vector<std::size_t> drawn_rows(const Figure& figure,
                                                  const Panel& panel,
                                                  const Layer& layer,
                                                  const std::string& class_name = "");

/// Classes of the key that some layer draws, in the key's order.
[[nodiscard]] std::vector<std::string> drawn_classes(const Figure& figure);

/// For each row the name of the series to which it belongs: its part, its panel and the classes
/// that divide the part into lines.
[[nodiscard]] std::vector<std::string> series_names(const Figure& figure);

}  // namespace tcert
