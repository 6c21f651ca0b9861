#pragma once
/// \file
/// The robot, its rays and the course in bundle.json.

#include <table/json_object.hpp>
#include <tcert/robot.hpp>

namespace tcert {

/// From the keys `robot` and `rays`. Problems are reported; the robot is valid if there are none.
[[nodiscard]] Robot read_robot(const table::JsonObject& bundle);

/// From the key `course`; either region may be absent.
[[nodiscard]] Course read_course(const table::JsonObject& bundle);

[[nodiscard]] nlohmann::ordered_json ray_json(const Ray& ray);
[[nodiscard]] nlohmann::ordered_json region_json(const Region& region);

}  // namespace tcert
