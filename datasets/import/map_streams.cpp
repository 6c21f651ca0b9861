#include "datasets/import/map_streams.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "datasets/bundle_fields.hpp"
#include "datasets/import/map_fields.hpp"
#include "datasets/import/map_values.hpp"

namespace tcert::recording {
namespace {

using table::JsonObject;
using PlainJson = nlohmann::json;

constexpr std::size_t kMostRayStreams = 256;

/// A key that would be read and then not count is an error.
void reject_idle(const JsonObject& from,
                 std::initializer_list<const char*> keys,
                 const char* expectation) {
  for (const char* const key : keys) {
    if (const PlainJson* value = from.find(key)) {
      from.reject(key, *value, expectation);
    }
  }
}

/// Where the stream comes from, and its clock.
StreamSource read_stream(const JsonObject& from) {
  StreamSource stream;
  stream.topic = from.text("from").value_or("");
  stream.file = from.text("file").value_or("");
  if (!stream.topic.empty() && !stream.file.empty()) {
    from.reject("file", stream.file, "either 'from', a topic, or 'file', of columns");
  }
  const std::filesystem::path file(stream.file);
  if (file.is_absolute() || std::ranges::find(file, "..") != file.end()) {
    from.reject("file", stream.file, "a file below the source, which the command line names");
  }
  if (stream.topic.empty()) {
    reject_idle(from, {"frame", "parent"}, "no such key: only topics of transforms have frames");
  } else {
    reject_idle(from, {"time"}, "no such key: the clock of topics is 'clock' of the map");
  }
  stream.time = read_time(from);
  stream.child_frame = from.text("frame").value_or("");
  stream.parent_frame = from.text("parent").value_or("");
  return stream;
}

void read_no_return(const JsonObject& from, NoReturn& rule) {
  if (const PlainJson* list = from.find("no_return")) {
    const bool is_list = list->is_array();
    if (!is_list) {
      from.reject("no_return", *list, R"(a list of numbers and "inf")");
    }
    for (const PlainJson& one : is_list ? *list : PlainJson::array()) {
      if (one.is_number()) {
        rule.values.push_back(one.get<double>());
      } else if (one != "inf") {  // which always is none
        from.reject("no_return", one, R"(a number or "inf")");
      }
    }
  }
  rule.range_min_m = from.number("range_min_m");
  rule.range_max_m = from.number("range_max_m");
}

/// The keys of a range ray that say how to read it are used up here: the bundle gets what they
/// make.
MappedRay read_ray(const JsonObject& rays, const std::string& path, const PlainJson& value) {
  std::vector<std::string> keys = map_keys({"mapped ray"});
  const std::vector<std::string> ours = names_at("ray", bundle_fields());
  keys.insert(keys.end(), ours.begin(), ours.end());
  const JsonObject from = rays.child(path, value, keys);
  MappedRay ray;
  if (!value.is_object()) {
    return ray;
  }
  ray.ray = value;
  for (const std::string& key : map_keys({"mapped ray"})) {
    ray.ray.erase(key);
  }
  read_no_return(from, ray.no_return);
  for (const char* const key : {"no_return", "range_min_m", "range_max_m"}) {
    ray.ray.erase(key);
  }
  if (const auto degrees = from.number("bearing_deg")) {
    if (value.contains("bearing_rad")) {
      from.reject("bearing_deg", *degrees, "either a bearing in degrees or one in radians");
    }
    ray.ray["bearing_rad"] = *degrees * std::numbers::pi / 180.0;
  }
  const bool bends = value.value("kind", PlainJson()) == "bend";
  ray.value = read_value(from, bends ? "bend_rad" : "range_m", bends ? "bend_rad" : "range_m");
  ray.force = read_value(from, "fsr_n", "fsr_n");
  if (const char* const other = bends ? "range_m" : "bend_rad"; value.contains(other)) {
    from.reject(other,
                value.at(other),
                bends ? "bend_rad: the ray is of kind bend" : "range_m: the ray is of kind range");
  }
  return ray;
}

ScanOffset read_offset(const JsonObject& from) {
  ScanOffset offset;
  const PlainJson* value = from.find("offset");
  if (value == nullptr) {
    return offset;
  }
  if (value->is_string()) {
    offset.by_transforms = *value == "tf_static";
    if (!offset.by_transforms) {
      from.reject("offset", *value, R"("tf_static" or an object with x_m, y_m and yaw_rad)");
    }
    return offset;
  }
  const JsonObject object = from.child("offset", *value, map_keys({"offset"}));
  offset.x_m = object.number("x_m").value_or(0.0);
  offset.y_m = object.number("y_m").value_or(0.0);
  offset.yaw_rad = object.number("yaw_rad").value_or(0.0);
  return offset;
}

StreamSource read_ray_stream(const JsonObject& map,
                             const std::string& path,
                             const PlainJson& value) {
  const JsonObject from = map.child(path, value, map_keys({"stream", "rays"}));
  StreamSource stream = read_stream(from);
  read_no_return(from, stream.no_return);
  if (const PlainJson* rays = from.find("rays")) {
    if (!rays->is_array() || rays->empty()) {
      from.reject("rays", *rays, "a list of at least one ray");
    } else {
      for (std::size_t i = 0; i < rays->size(); ++i) {
        const std::string place = "rays[" + std::to_string(i) + "]";
        stream.rays.push_back(read_ray(from, place, (*rays)[i]));
        if (stream.topic.empty() && !stream.rays.back().value.is_given()) {
          from.reject(place, (*rays)[i], "a ray with its value: bend_rad or range_m, a column");
        }
      }
    }
    reject_idle(from,
                {"ranges", "every", "angle_min_rad", "angle_increment_rad", "reach_m", "offset"},
                "no such key beside 'rays': it is of a scan, and these rays are listed");
    return stream;
  }
  ScanSource scan;
  scan.ranges = from.text("ranges").value_or("");
  if (const auto every = from.number("every")) {
    const bool is_count = *every >= 1.0 && *every <= 4096.0 && *every == std::floor(*every);
    if (!is_count) {
      from.reject("every", *every, "a whole number, 1 to 4096");
    }
    scan.every = is_count ? static_cast<std::size_t>(*every) : 1;
  }
  scan.angle_min_rad = from.number("angle_min_rad");
  scan.angle_increment_rad = from.number("angle_increment_rad");
  scan.reach_m = from.number("reach_m");
  scan.offset = read_offset(from);
  stream.scan = scan;
  return stream;
}

}  // namespace

StreamSource read_valued_stream(const JsonObject& map,
                                const std::string& key,
                                const std::vector<std::string>& columns) {
  const JsonObject from = map.child(key, *map.find(key), map_keys({"stream", key}));
  StreamSource stream = read_stream(from);
  for (const std::string& column : columns) {
    stream.values.push_back(read_value(from, column, column));
    // What a topic has is known by its type; columns must be named.
    if (key == "pose" && stream.topic.empty() && from.find(column) == nullptr) {
      from.reject(column, PlainJson(), "a column of the pose's file");
    }
  }
  return stream;
}

std::vector<StreamSource> read_ray_streams(const JsonObject& map) {
  std::vector<StreamSource> streams;
  const PlainJson* value = map.require("rays");
  if (value == nullptr) {
    return streams;
  }
  if (!value->is_array()) {
    streams.push_back(read_ray_stream(map, "rays", *value));
    return streams;
  }
  if (value->empty() || value->size() > kMostRayStreams) {
    map.reject("rays", *value, "a stream of rays, or a list of 1 to 256");
    return streams;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    streams.push_back(read_ray_stream(map, "rays[" + std::to_string(i) + "]", (*value)[i]));
  }
  return streams;
}

}  // namespace tcert::recording
