#pragma once
/// \file
/// The folder of a rosbag2 recording as one bag.

#include <filesystem>
#include <memory>
#include <table/diagnostic.hpp>

#include "datasets/import/bag.hpp"

namespace tcert::recording {

/// True if the folder is one recording: has what its metadata.yaml lists, or, without one, files
/// whose names end in .db3 or .mcap (or in those and .zstd) and differ in the number alone that
/// rosbag2 puts behind them ("run_0.db3", "run_1.db3"). A folder of several recordings is none.
[[nodiscard]] bool is_bag_folder(const std::filesystem::path& path);

/// As open_bag(). A file that cannot be read is left out (warning) unless it is the only one;
/// topics of the same name, type and encoding are one.
[[nodiscard]] std::unique_ptr<Bag> open_bag_folder(const std::filesystem::path& path,
                                                   table::DiagnosticGroups& problems);

}  // namespace tcert::recording
