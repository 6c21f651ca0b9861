#pragma once
/// \file
/// A figure as a gnuplot 5.4 script that draws it from its CSV file.

#include <string>

#include "reports/figure/figure.hpp"

namespace tcert {

/// The script reads <name>.csv in the current folder: `gnuplot -c NAME.gp svg` writes <name>.svg,
/// `gnuplot -c NAME.gp pdf` <name>.pdf, `png` <name>.png. Polygons are the only data in the script
/// itself. Nothing in it depends on the machine or the time, so equal figures are equal bytes; a
/// PDF holds a date unless SOURCE_DATE_EPOCH is set.
[[nodiscard]] std::string gnuplot_script(const Figure& figure);

}  // namespace tcert
