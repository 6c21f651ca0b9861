#pragma once
/// \file
/// The keys of a ray in bundle.json that say what its readings mean.

#include <table/json_object.hpp>
#include <tcert/robot.hpp>

#include "datasets/range_rule.hpp"

namespace tcert {

/// From the keys no_return, range_min_m and range_max_m of one ray; problems are reported. A ray of
/// another kind than range has none of them.
[[nodiscard]] RangeKeys read_range_keys(const table::JsonObject& ray, RayKind kind);

/// Adds what is declared to the JSON of a ray.
void add_range_keys(const RangeKeys& keys, nlohmann::ordered_json& ray);

}  // namespace tcert
