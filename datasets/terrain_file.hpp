#pragma once
/// \file
/// Terrain files: a rectangle of numbers, one line a row; a list of points; an ESRI ASCII grid.

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert {

// Bounds of a terrain, for memory and work.
inline constexpr std::size_t kMostTerrainCells = std::size_t{1} << 26U;
inline constexpr int kMostTerrainSide = 8192;
inline constexpr double kLargestTerrainValue = 1e30;

/// Where the cells lie on a map: the centre of cell (x, y) is at the origin, x steps along the rows
/// and y steps along the columns.
struct MapFrame {
  double east = 0.0;  ///< First coordinate of the centre of cell (0, 0).
  double north = 0.0;
  /// Rows run from north to south and columns from west to east, as in an ESRI grid; else x counts
  /// the first coordinate and y the second, both upwards, as in a list of points.
  bool rows_run_south = false;
  double x_step = 1.0;  ///< Metres, or whatever the map is in, from one x to the next; > 0.
  double y_step = 1.0;
  bool is_declared = false;  ///< By the file; else all of it is what there is by default.

  [[nodiscard]] double first_of(double x, double y) const noexcept {
    return east + (rows_run_south ? y * y_step : x * x_step);
  }
  [[nodiscard]] double second_of(double x, double y) const noexcept {
    return rows_run_south ? north - x * x_step : north + y * y_step;
  }
  [[nodiscard]] bool is_square() const noexcept {
    return std::abs(x_step - y_step) <= 1e-6 * x_step;
  }
};

/// Row-major values; row x of the file is x = 0, 1, ... NaN is a gap: nothing is known there.
struct TerrainGrid {
  int rows = 0;
  int columns = 0;
  std::vector<double> values;
  std::string header;  ///< The line that was dropped as such; empty if there was none.
  MapFrame frame{};
};

enum class TerrainHeader {
  /// The first line is a header if it has a word and no number, or if it numbers the columns: 0, 1,
  /// 2, ... or 1, 2, 3, ..., or evenly spaced coordinates far from the values below, and the next
  /// line is not evenly spaced.
  detect,
  yes,  ///< The first line is dropped, whatever it is.
  no,
};

enum class TerrainFormat {
  detect,
  grid,    ///< A rectangle of numbers, one line a row.
  points,  ///< x, y and value, one point a line, in any order.
  esri,    ///< ESRI ASCII grid (Arc/Info): ncols, nrows, xllcorner, ..., then the values.
};

/// Which values mean that nothing is known; NaN and words for it always do.
struct NodataRule {
  /// Values beyond +-1e30, and -9999, -32768 and others of their kind where they lie outside of all
  /// other values by half their range or more. Not if `declared`: then that value and those beyond
  /// +-1e30 alone.
  bool recognise = true;
  std::optional<double> declared;
};

struct TerrainFileOptions {
  std::string file;  ///< For messages.
  TerrainHeader header = TerrainHeader::detect;
  TerrainFormat format = TerrainFormat::detect;
  NodataRule nodata{};
};

struct TerrainFileResult {
  std::optional<TerrainGrid> terrain;
  std::vector<table::Diagnostic> diagnostics;
  std::vector<std::string> notes;  ///< How the file was understood, a sentence each.
};

/// Comma, semicolon, tab or blanks between the numbers, whichever the first row uses; # begins a
/// comment line. Three columns whose first two run over an evenly spaced lattice are points: x
/// counts the lattice along the first, y along the second, both upwards, and nodes without a point
/// are gaps. Three columns of 16 lines or more that form none are refused, unless they are said to
/// be a grid or lines begin alike: then a note says so. Rejects binary files by what they are,
/// lines of different lengths, cells that are neither numbers nor gaps, three columns that may be
/// points but form no lattice, fewer than two rows or columns, and more than 2^26 cells or 8192 a
/// side, naming line and cell. O(size), for points O(points log points).
[[nodiscard]] TerrainFileResult read_terrain(const table::Bytes& bytes,
                                             const TerrainFileOptions& options);

/// The same from a file, expanded if it ends in .gz or .zst.
[[nodiscard]] TerrainFileResult read_terrain(const std::filesystem::path& path,
                                             TerrainFileOptions options = {});

/// The text of a terrain file: shortest decimals that read back to the same bits; nan for a gap.
[[nodiscard]] std::string terrain_text(const TerrainGrid& terrain);

}  // namespace tcert
