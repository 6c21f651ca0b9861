#pragma once
/// \file
/// A layer of a figure as a view of Vega-Lite. Internal to reports/figure.

#include <string>

#include "reports/figure/figure.hpp"
#include "reports/table_json.hpp"

namespace tcert {

/// The channel x or y of a column.
[[nodiscard]] OrderedJson vega_position(const Axis& axis, const std::string& field, bool vertical);

/// Its rows, its mark, its channels.
[[nodiscard]] OrderedJson vega_layer(const Figure& figure, const Panel& panel, const Layer& layer);

}  // namespace tcert
