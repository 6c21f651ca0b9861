#pragma once
/// \file
/// The folder of a rosbag2 recording as one bag.

#include <filesystem>
#include <memory>
#include <table/diagnostic.hpp>

#include "datasets/import/bag.hpp"

namespace tcert::recording {

/// True if the folder has recordings: what its metadata.yaml lists, else files whose names end in
/// .db3 or .mcap (or in those and .zstd).
[[nodiscard]] bool is_bag_folder(const std::filesystem::path& path);

/// As open_bag(). A file that cannot be read is left out (warning) unless it is the only one;
/// topics of the same name, type and encoding are one.
[[nodiscard]] std::unique_ptr<Bag> open_bag_folder(const std::filesystem::path& path,
                                                   table::DiagnosticGroups& problems);

}  // namespace tcert::recording
