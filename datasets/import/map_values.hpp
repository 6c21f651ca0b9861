#pragma once
/// \file
/// Values, times and words of a map. Internal to log_map.cpp and map_streams.cpp.

#include <initializer_list>
#include <string>
#include <string_view>
#include <table/json_object.hpp>
#include <vector>

#include "datasets/import/log_map.hpp"

namespace tcert::recording {

/// Keys of the objects of those kinds, as map_fields() declares them.
[[nodiscard]] std::vector<std::string> map_keys(std::initializer_list<std::string_view> places);

/// A list of texts; empty if it is absent or, reported, something else.
[[nodiscard]] std::vector<std::string> read_texts(const table::JsonObject& from,
                                                  const std::string& key);

/// `unit`, of the quantity of our column `name`, or `scale`.
void read_scale(const table::JsonObject& from, std::string_view name, double& scale);

/// The value of our column `name` under `key`: a column's name, or an object.
[[nodiscard]] ValueSource read_value(const table::JsonObject& from,
                                     const std::string& key,
                                     std::string_view name);

/// `time` of a stream.
[[nodiscard]] TimeSource read_time(const table::JsonObject& stream);

}  // namespace tcert::recording
