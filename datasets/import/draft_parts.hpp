#pragma once
/// \file
/// What drafts of topics and of columns have in common. Internal to draft_map.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "datasets/import/draft_map.hpp"

namespace tcert::recording {

using OrderedJson = nlohmann::ordered_json;

/// The map with its fixed keys; null where a person must fill in.
[[nodiscard]] OrderedJson frame_of_map();

/// A ray with its fixed keys; null where a person must fill in.
[[nodiscard]] OrderedJson frame_of_ray(const std::string& name, std::string_view kind);

/// The map as text; the first remark names each null that is left in it.
[[nodiscard]] DraftedMap finished(const OrderedJson& map, std::vector<std::string> remarks);

/// True if `part` stands in the name, whatever its case.
[[nodiscard]] bool is_called(const std::string& name, std::string_view part);

/// The part of a ray's column that is the name of the ray: "left" of "left_range_mm".
[[nodiscard]] std::string ray_name(const std::string& column, std::size_t number);

}  // namespace tcert::recording
