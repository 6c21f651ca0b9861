#pragma once
/// \file
/// CSV files as streams of a bundle, by the map.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/log_map.hpp"
#include "datasets/import/ray_layout.hpp"
#include "datasets/import/stream_set.hpp"

namespace tcert::recording {

/// The file of each stream of the map; empty for control that is not there.
using StreamFiles = std::vector<std::filesystem::path>;

struct CsvReadOptions {
  bool decimal_comma = false;
};

/// The rays of each stream of rays, from the map; of a scan in columns from the header of its file
/// and, where the map does not say them, from its columns angle_min, angle_increment, range_min and
/// range_max, as `rostopic echo -p` writes them. Empty iff there is an error.
[[nodiscard]] std::optional<std::vector<RayLayout>> find_layouts(const StreamFiles& files,
                                                                 const LogMap& map,
                                                                 const CsvReadOptions& options,
                                                                 table::DiagnosticGroups& problems);

/// The streams of a trial, by the cell of the map's column of trials (empty without one). Nothing
/// for rows that belong to no trial.
using StreamsOfTrial = std::function<StreamSet*(std::string_view trial)>;

/// Reads all rows of all files. A file that is the source of several streams is read for each.
/// False if a file or a column that is required is missing. \throws table::WriteError.
[[nodiscard]] bool read_csv_streams(const StreamFiles& files,
                                    const LogMap& map,
                                    const std::vector<RayLayout>& layouts,
                                    const CsvReadOptions& options,
                                    const StreamsOfTrial& streams_of,
                                    table::DiagnosticGroups& problems);

}  // namespace tcert::recording
