#pragma once
/// \file
/// The database of a rosbag2 recording as a bag.

#include <filesystem>
#include <memory>
#include <table/diagnostic.hpp>

#include "datasets/import/bag.hpp"

namespace tcert::recording {

/// One .db3 file, as open_bag(). Messages that rosbag2 packed one by one are expanded.
[[nodiscard]] std::unique_ptr<Bag> open_sqlite_bag(const std::filesystem::path& path,
                                                   table::DiagnosticGroups& problems);

}  // namespace tcert::recording
