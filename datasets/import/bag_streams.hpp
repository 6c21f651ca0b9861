#pragma once
/// \file
/// The topics of a bag as streams of a bundle, by the map.

#include <filesystem>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/bag.hpp"
#include "datasets/import/log_map.hpp"
#include "datasets/import/ray_layout.hpp"
#include "datasets/import/stream_set.hpp"

namespace tcert::recording {

/// The rays of each stream of rays, from the map and the first scan of each topic; `/tf_static` is
/// asked for the places of scanners. One pass, which ends when all is known. Errors: a topic that
/// is not there (with the nearest), a type that needs columns in the map, no scan, no transform.
/// Empty iff there is an error.
[[nodiscard]] std::optional<std::vector<RayLayout>> find_layouts(Bag& bag,
                                                                 const std::string& file,
                                                                 const LogMap& map,
                                                                 table::DiagnosticGroups& problems);

/// Reads all messages of the map's topics into `set`; memory does not grow with the file.
/// Messages that cannot be decoded, and scans of other beams than the layout, are samples that
/// cannot be read; each kind is a counted warning. False if a topic is missing.
/// \throws table::WriteError.
[[nodiscard]] bool read_bag_streams(Bag& bag,
                                    const std::string& file,
                                    const LogMap& map,
                                    const std::vector<RayLayout>& layouts,
                                    StreamSet& set,
                                    table::DiagnosticGroups& problems);

}  // namespace tcert::recording
