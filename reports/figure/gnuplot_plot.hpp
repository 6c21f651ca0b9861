#pragma once
/// \file
/// The plot commands of a panel. Internal to reports/figure.

#include <string>

#include "reports/figure/figure.hpp"

namespace tcert {

/// Functions that turn the categories of each panel's axes into positions.
[[nodiscard]] std::string class_functions(const Figure& figure);

/// Polygons of the panel as objects.
[[nodiscard]] std::string polygon_objects(const Figure& figure, const Panel& panel);

/// One clause for each layer and class.
[[nodiscard]] std::string plot_command(const Figure& figure, const Panel& panel);

/// A plot of nothing, with an entry of the legend for each class that is drawn.
[[nodiscard]] std::string key_entries(const Figure& figure);

}  // namespace tcert
