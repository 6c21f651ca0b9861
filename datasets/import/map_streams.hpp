#pragma once
/// \file
/// The streams of a map. Internal to log_map.cpp.

#include <string>
#include <table/json_object.hpp>
#include <vector>

#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// The stream under `key`, with the values of its `columns`. \pre the map has the key.
[[nodiscard]] StreamSource read_valued_stream(const table::JsonObject& map,
                                              const std::string& key,
                                              const std::vector<std::string>& columns);

/// The streams under "rays": one, or a list of at most 256.
[[nodiscard]] std::vector<StreamSource> read_ray_streams(const table::JsonObject& map);

}  // namespace tcert::recording
