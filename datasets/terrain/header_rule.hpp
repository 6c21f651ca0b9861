#pragma once
/// \file
/// Whether the first line of a terrain file is data.

#include <span>
#include <string>

#include "datasets/terrain/cell_table.hpp"
#include "datasets/terrain_file.hpp"

namespace tcert::terrain_reading {

struct HeaderDecision {
  bool header = false;        ///< The first line is no data.
  bool index_column = false;  ///< Nor is the first column: it numbers the rows.
  std::string note;           ///< What was dropped, or could have been, and how to say otherwise.
};

/// As TerrainHeader has it. A first column of row numbers or row coordinates is dropped if the
/// header has nothing, or a word, or no cell above it. O(columns + rows). \pre the table has no
/// problems
[[nodiscard]] HeaderDecision decide_header(const CellTable& table, TerrainHeader mode);

/// Three numbers or more, one as far from the next as any other, and not equal.
[[nodiscard]] bool is_evenly_spaced(std::span<const double> values);

}  // namespace tcert::terrain_reading
