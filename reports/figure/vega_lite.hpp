#pragma once
/// \file
/// A figure as a Vega-Lite 5 specification.

#include <nlohmann/json.hpp>

#include "reports/figure/figure.hpp"

namespace tcert {

/// The specification with its rows inline (`data.values`, the cells of figure_csv(), null where
/// missing). It needs no expression that is not a constant or a plain field look-up, so it runs
/// under vega-interpreter. One panel: a layered view with `width: "container"`. Several: `concat`
/// with `columns`; each has a width in pixels that a page may change, as it may change `columns`.
/// Everything in ink, muted or faint has the mark style of that name (`ink`, `ink-text` and so on;
/// polygons `filled-faint`) in `config.style`; a page sets `config` for dark and light.
[[nodiscard]] nlohmann::ordered_json vega_lite(const Figure& figure);

}  // namespace tcert
