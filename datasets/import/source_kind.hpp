#pragma once
/// \file
/// What somebody's file or folder is, by what it holds and never by its name.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tcert::recording {

enum class SourceKind : std::uint8_t {
  bundle,      ///< A folder with a bundle.json, or a .zip.
  bag,         ///< MCAP, rosbag2.
  carmen,      ///< FLASER, ROBOTLASER1 and ODOM records.
  barn,        ///< Result text of the BARN challenge.
  json,        ///< A map, a bundle.json, a world, JSON Lines.
  csv,         ///< Any table in columns.
  csv_folder,  ///< A folder below which such files lie.
  binary,      ///< Named by table::kind_of_binary().
  unreadable,
};

/// Looks at the first 64 kB of a file, expanded, or at the names in a folder.
[[nodiscard]] SourceKind source_kind(const std::filesystem::path& path);

/// Which program writes tables like that, by the names of their columns or by the shape of their
/// rows: "an export of rostopic echo -p", "a TUM trajectory", ...; empty if it is not known.
[[nodiscard]] std::string_view writer_of(const std::vector<std::string>& names,
                                         std::size_t header_line);

}  // namespace tcert::recording
