#include "datasets/import/log_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <table/json_object.hpp>
#include <utility>

#include "datasets/bundle_fields.hpp"
#include "datasets/import/map_fields.hpp"
#include "datasets/import/unit_word.hpp"

namespace tcert::recording {
namespace {

using Json = nlohmann::json;
using table::JsonObject;

constexpr std::size_t kMostRayStreams = 256;

/// Keys of the objects of those kinds.
std::vector<std::string> keys_of(std::initializer_list<std::string_view> places) {
  std::vector<std::string> keys;
  for (const std::string_view place : places) {
    const std::vector<std::string> more = names_at(place, map_fields());
    keys.insert(keys.end(), more.begin(), more.end());
  }
  return keys;
}

/// Keys of bundle.json that a map may have too.
std::vector<std::string> bundle_keys() {
  const std::set<std::string_view> own{
      "format", "version", "synthetic", "seed", "provenance", "rays", "columns"};
  std::vector<std::string> keys;
  for (const std::string& name : names_at("bundle.json", bundle_fields())) {
    if (!own.contains(name)) {
      keys.push_back(name);
    }
  }
  return keys;
}

bool is_text(const Json& value) { return value.is_string(); }

std::vector<std::string> texts(const JsonObject& from, const std::string& key) {
  const Json* list = from.list(key, is_text, "a list of texts");
  return list == nullptr ? std::vector<std::string>{} : list->get<std::vector<std::string>>();
}

std::string in_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

void read_scale(const JsonObject& from, std::string_view name, double& scale) {
  const Json* unit = from.find("unit");
  if (unit != nullptr && from.find("scale") != nullptr) {
    from.reject("unit", *unit, "either a unit or a scale");
  }
  if (unit != nullptr) {
    const auto found =
        unit->is_string() ? unit_scale(name, unit->get<std::string>()) : std::nullopt;
    if (!found) {
      from.reject("unit", *unit, "one of " + in_words(units_of(name)));
    }
    scale = found.value_or(1.0);
  }
  scale = from.number("scale").value_or(scale);
}

/// The value of our column `name` under `key`: a column's name, or an object.
ValueSource read_value(const JsonObject& from, const std::string& key, std::string_view name) {
  ValueSource source;
  const Json* value = from.find(key);
  if (value == nullptr) {
    return source;
  }
  if (value->is_string()) {
    source.columns = {value->get<std::string>()};
    return source;
  }
  const JsonObject object = from.child(key, *value, keys_of({"value"}));
  if (const auto column = object.text("column")) {
    source.columns = {*column};
  }
  if (object.find("quaternion") != nullptr) {
    source.columns = texts(object, "quaternion");
    if (source.columns.size() != 4 || object.find("column") != nullptr ||
        name != pose_columns().back()) {
      from.reject(key, *value, "of a yaw, a quaternion of four columns x, y, z, w and no column");
    }
  } else if (source.columns.empty() && value->is_object()) {
    from.reject(key, *value, "a column or a quaternion");
  }
  read_scale(object, name, source.scale);
  source.add = object.number("add").value_or(0.0);
  return source;
}

TimeSource read_time(const JsonObject& stream) {
  TimeSource time;
  const Json* value = stream.find("time");
  if (value == nullptr) {
    return time;
  }
  if (value->is_string()) {
    time.columns = {value->get<std::string>()};
    return time;
  }
  const JsonObject object = stream.child("time", *value, keys_of({"time"}));
  const Json* column = object.find("column");
  if (column != nullptr && column->is_string()) {
    time.columns = {column->get<std::string>()};
  } else if (column != nullptr) {
    time.columns = texts(object, "column");
    if (time.columns.size() != 2) {
      object.reject("column", *column, "a column, or two of seconds and nanoseconds");
    }
  }
  if (const Json* unit = object.find("unit")) {
    const std::string word = unit->is_string() ? unit->get<std::string>() : "";
    time.dates = word == "iso";
    time.unit = table::time_unit_of_word(word);
    if (!time.dates && !time.unit) {
      object.reject("unit", *unit, "s, ms, us, ns or iso");
    }
  }
  if (const Json* origin = object.find("origin")) {
    time.from_first = *origin == "first";
    if (!time.from_first) {
      object.reject("origin", *origin, "\"first\"");
    }
  }
  return time;
}

/// Where the stream comes from, and its clock.
StreamSource read_stream(const JsonObject& from) {
  StreamSource stream;
  stream.topic = from.text("from").value_or("");
  stream.file = from.text("file").value_or("");
  if (!stream.topic.empty() && !stream.file.empty()) {
    from.reject("file", stream.file, "either 'from', a topic, or 'file', of columns");
  }
  stream.time = read_time(from);
  stream.child_frame = from.text("frame").value_or("");
  stream.parent_frame = from.text("parent").value_or("");
  return stream;
}

StreamSource read_valued(const JsonObject& map,
                         const std::string& key,
                         const std::vector<std::string>& columns) {
  const JsonObject from = map.child(key, *map.find(key), keys_of({"stream", key}));
  StreamSource stream = read_stream(from);
  for (const std::string& column : columns) {
    stream.values.push_back(read_value(from, column, column));
  }
  return stream;
}

MappedRay read_ray(const JsonObject& rays, const std::string& path, const Json& value) {
  std::vector<std::string> keys = keys_of({"mapped ray"});
  const std::vector<std::string> ours = names_at("ray", bundle_fields());
  keys.insert(keys.end(), ours.begin(), ours.end());
  const JsonObject from = rays.child(path, value, keys);
  MappedRay ray;
  if (!value.is_object()) {
    return ray;
  }
  ray.ray = value;
  for (const std::string& key : keys_of({"mapped ray"})) {
    ray.ray.erase(key);
  }
  if (const auto degrees = from.number("bearing_deg")) {
    if (value.contains("bearing_rad")) {
      from.reject("bearing_deg", *degrees, "either a bearing in degrees or one in radians");
    }
    ray.ray["bearing_rad"] = *degrees * std::numbers::pi / 180.0;
  }
  const bool bends = value.value("kind", Json()) == "bend";
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
  const Json* value = from.find("offset");
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
  const JsonObject object = from.child("offset", *value, keys_of({"offset"}));
  offset.x_m = object.number("x_m").value_or(0.0);
  offset.y_m = object.number("y_m").value_or(0.0);
  offset.yaw_rad = object.number("yaw_rad").value_or(0.0);
  return offset;
}

void read_no_return(const JsonObject& from, NoReturn& rule) {
  if (const Json* list = from.find("no_return")) {
    rule.infinite = false;
    const bool is_list = list->is_array();
    if (!is_list) {
      from.reject("no_return", *list, R"(a list of numbers and "inf")");
    }
    for (const Json& one : is_list ? *list : Json::array()) {
      if (one == "inf") {
        rule.infinite = true;
      } else if (one.is_number()) {
        rule.values.push_back(one.get<double>());
      } else {
        from.reject("no_return", one, R"(a number or "inf")");
      }
    }
  }
  rule.range_min_m = from.number("range_min_m");
  rule.range_max_m = from.number("range_max_m");
}

StreamSource read_ray_stream(const JsonObject& map, const std::string& path, const Json& value) {
  const JsonObject from = map.child(path, value, keys_of({"stream", "rays"}));
  StreamSource stream = read_stream(from);
  read_no_return(from, stream.no_return);
  if (const Json* rays = from.find("rays")) {
    if (!rays->is_array() || rays->empty()) {
      from.reject("rays", *rays, "a list of at least one ray");
    } else {
      for (std::size_t i = 0; i < rays->size(); ++i) {
        stream.rays.push_back(read_ray(from, "rays[" + std::to_string(i) + "]", (*rays)[i]));
      }
    }
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

std::vector<StreamSource> read_ray_streams(const JsonObject& map) {
  std::vector<StreamSource> streams;
  const Json* value = map.require("rays");
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

void read_outcome(const JsonObject& trials, const std::string& name, TrialsSource& source) {
  const Json* value = trials.find(name);
  if (value == nullptr) {
    return;
  }
  OutcomeSource outcome;
  outcome.name = name;
  if (value->is_string()) {
    outcome.column = value->get<std::string>();
  } else if (name == "success") {
    const JsonObject object = trials.child(name, *value, keys_of({"success"}));
    outcome.column = object.require("column") == nullptr ? "" : object.text("column").value_or("");
    outcome.success_words = texts(object, "true");
    outcome.failure_words = texts(object, "false");
  } else {
    const JsonObject object = trials.child(name, *value, keys_of({"outcome"}));
    outcome.column = object.require("column") == nullptr ? "" : object.text("column").value_or("");
    read_scale(object, name, outcome.scale);
  }
  source.outcomes.push_back(std::move(outcome));
}

TrialsSource read_trials(const JsonObject& map) {
  TrialsSource source;
  const Json* value = map.find("trials");
  if (value == nullptr) {
    return source;
  }
  const JsonObject from = map.child("trials", *value, keys_of({"trials"}));
  if (const Json* split = from.find("split"); split != nullptr && *split != "file") {
    const JsonObject object = from.child("split", *split, keys_of({"split"}));
    source.column = object.require("column") == nullptr ? "" : object.text("column").value_or("");
  }
  source.table = from.text("table").value_or("");
  source.id = from.text("id").value_or("trial_id");
  const std::set<std::string_view> others{"split", "table", "id"};
  for (const std::string& key : keys_of({"trials"})) {
    if (!others.contains(key)) {
      read_outcome(from, key, source);
    }
  }
  if (source.table.empty() && !source.outcomes.empty()) {
    from.reject("table", Json(), "a file, of which the other keys name columns");
  }
  return source;
}

/// Streams come from topics or from files, all of them: they share one source and one clock.
void require_one_kind(const JsonObject& map, const LogMap& log) {
  std::vector<const StreamSource*> streams{&log.pose};
  for (const StreamSource& stream : log.rays) {
    streams.push_back(&stream);
  }
  if (log.control) {
    streams.push_back(&*log.control);
  }
  const bool any = std::ranges::any_of(streams, [](auto* one) { return !one->topic.empty(); });
  const bool all = std::ranges::all_of(streams, [](auto* one) { return !one->topic.empty(); });
  if (any && !all) {
    map.reject("pose",
               log.document.value("pose", Json()),
               "streams that are all topics ('from') or all files: one source, one clock");
  }
}

}  // namespace

const std::vector<std::string>& pose_columns() {
  static const std::vector<std::string> columns = keys_of({"pose"});
  return columns;
}

const std::vector<std::string>& control_columns() {
  static const std::vector<std::string> columns = keys_of({"control"});
  return columns;
}

std::optional<LogMap> parse_log_map(std::string_view text,
                                    const std::string& file,
                                    table::DiagnosticGroups& problems) {
  const std::optional<Json> document = table::parse_json(text, file, problems);
  if (!document) {
    return std::nullopt;
  }
  std::vector<std::string> keys = keys_of({"map"});
  const std::vector<std::string> of_bundle = bundle_keys();
  keys.insert(keys.end(), of_bundle.begin(), of_bundle.end());
  const JsonObject map(*document, "", keys, file, problems);
  LogMap log;
  log.document = *document;
  if (const Json* format = map.find("format"); format != nullptr && *format != "tcert-map") {
    map.reject("format", *format, "\"tcert-map\"");
  }
  if (const Json* version = map.find("version"); version != nullptr && *version != 1) {
    map.reject("version", *version, "1");
  }
  if (const Json* clock = map.find("clock")) {
    log.header_clock = *clock == "header";
    if (!log.header_clock && *clock != "log") {
      map.reject("clock", *clock, R"("log" or "header")");
    }
  }
  log.base_frame = map.text("base_frame").value_or(log.base_frame);
  if (map.require("pose") != nullptr) {
    log.pose = read_valued(map, "pose", pose_columns());
  }
  log.rays = read_ray_streams(map);
  if (map.find("control") != nullptr) {
    log.control = read_valued(map, "control", control_columns());
  }
  log.trials = read_trials(map);
  require_one_kind(map, log);
  for (const std::string& key : of_bundle) {
    if (const Json* value = map.find(key)) {
      log.bundle[key] = *value;
    }
  }
  return problems.has_error() ? std::nullopt : std::optional(std::move(log));
}

}  // namespace tcert::recording
