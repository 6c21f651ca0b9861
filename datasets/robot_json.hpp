#pragma once
/// \file
/// The robot, its rays and the course in bundle.json.

#include <table/json_object.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/range_rule.hpp"

namespace tcert {

/// From the keys `robot` and `rays`; what is declared of the readings of each ray goes to `keys`.
/// Problems are reported; the robot is valid if there are none.
[[nodiscard]] Robot read_robot(const table::JsonObject& bundle, std::vector<RangeKeys>& keys);

/// From the key `course`; either region may be absent.
[[nodiscard]] Course read_course(const table::JsonObject& bundle);

[[nodiscard]] nlohmann::ordered_json ray_json(const Ray& ray, const RangeKeys& keys);
[[nodiscard]] nlohmann::ordered_json region_json(const Region& region);

}  // namespace tcert
