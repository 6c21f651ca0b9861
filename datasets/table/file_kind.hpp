#pragma once
/// \file
/// What a file is that should have been text, by its first bytes.

#include <optional>
#include <string>
#include <string_view>

namespace tcert::table {

/// "a GeoTIFF", and the command or change that makes text of it.
struct FileKind {
  std::string name;
  std::string way_out;
};

/// The name of a kind that is not known.
inline constexpr std::string_view kBinaryFile = "a binary file";

/// None for what may be text. Known by their first bytes: TIFF, PNG, JPEG, NumPy, HDF5, netCDF,
/// zip, gzip, zstd, bzip2, xz, PDF, Surfer, ERDAS, LAS, SQLite, MCAP, ROS 1 bags, PX4 logs, Parquet
/// and UTF-16; anything else that holds a NUL, or
/// more than one control character in fifty, is "a binary file". `file` is the name that way_out
/// uses.
[[nodiscard]] std::optional<FileKind> kind_of_binary(std::string_view bytes, std::string_view file);

/// Fit to follow "expected ": "text, but this is a GeoTIFF, not text: gdal_translate ...".
[[nodiscard]] std::string text_expected(const FileKind& kind);

}  // namespace tcert::table
