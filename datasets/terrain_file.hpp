#pragma once
/// \file
/// Terrain files: a rectangle of numbers, one line a row.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "datasets/bytes.hpp"
#include "datasets/diagnostic.hpp"

namespace tcert {

/// Row-major values; row x of the file is x = 0, 1, ...
struct TerrainGrid {
  int rows = 0;
  int columns = 0;
  std::vector<double> values;
  std::string header;  ///< The line that was dropped as such; empty if there was none.
};

enum class TerrainHeader {
  detect,  ///< The first line is a header if it has a cell and none of them is a number.
  yes,     ///< The first line is dropped, whatever it is.
  no,
};

struct TerrainFileOptions {
  std::string file;  ///< For messages.
  TerrainHeader header = TerrainHeader::detect;
};

struct TerrainFileResult {
  std::optional<TerrainGrid> terrain;
  std::vector<Diagnostic> diagnostics;
};

/// Comma, semicolon, tab or blanks between the numbers, whichever the first row uses. Rejects lines
/// of different lengths, cells that are not finite numbers, fewer than two rows or columns, and
/// more than 2^26 cells, naming line and cell. O(size).
[[nodiscard]] TerrainFileResult read_terrain(const Bytes& bytes, const TerrainFileOptions& options);

/// The same from a file, expanded if it ends in .gz or .zst.
[[nodiscard]] TerrainFileResult read_terrain(const std::filesystem::path& path,
                                             TerrainFileOptions options = {});

/// The text of a terrain file: shortest decimals that read back to the same bits.
[[nodiscard]] std::string terrain_text(const TerrainGrid& terrain);

}  // namespace tcert
