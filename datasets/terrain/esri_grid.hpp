#pragma once
/// \file
/// ESRI ASCII grids (Arc/Info): a few lines of names and values, then the cells.

#include <optional>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/terrain_file.hpp"

namespace tcert::terrain_reading {

struct EsriGrid {
  TerrainGrid
      terrain;  ///< x counts the file's rows, from north to south; y its columns, to the east.
  std::optional<double> nodata;
  std::string note;
  std::vector<table::Diagnostic> problems;
};

/// Whether the first line begins with one of the header's names.
[[nodiscard]] bool is_esri_grid(std::string_view text);

/// ncols, nrows, xllcorner or xllcenter, yllcorner or yllcenter, cellsize (or dx and dy) and
/// perhaps NODATA_value, in any order and case, a line each; then nrows x ncols numbers between
/// blanks, however they are broken into lines, the northernmost row first. O(size). \pre `text` is
/// of Bytes
[[nodiscard]] EsriGrid read_esri_grid(std::string_view text, const std::string& file);

}  // namespace tcert::terrain_reading
