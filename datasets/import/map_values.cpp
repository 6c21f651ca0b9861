#include "datasets/import/map_values.hpp"

#include <utility>

#include "datasets/import/map_fields.hpp"
#include "datasets/import/unit_word.hpp"

namespace tcert::recording {
namespace {

using table::JsonObject;

bool is_text_entry(const nlohmann::json& value) { return value.is_string(); }

std::string in_words(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + word;
  }
  return text;
}

}  // namespace

std::vector<std::string> map_keys(std::initializer_list<std::string_view> places) {
  std::vector<std::string> keys;
  for (const std::string_view place : places) {
    const std::vector<std::string> more = names_at(place, map_fields());
    keys.insert(keys.end(), more.begin(), more.end());
  }
  return keys;
}

std::vector<std::string> read_texts(const JsonObject& from, const std::string& key) {
  const nlohmann::json* list = from.list(key, is_text_entry, "a list of texts");
  return list == nullptr ? std::vector<std::string>{} : list->get<std::vector<std::string>>();
}

void read_scale(const JsonObject& from, std::string_view name, double& scale) {
  const nlohmann::json* unit = from.find("unit");
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

ValueSource read_value(const JsonObject& from, const std::string& key, std::string_view name) {
  ValueSource source;
  const nlohmann::json* value = from.find(key);
  if (value == nullptr) {
    return source;
  }
  if (value->is_string()) {
    source.columns = {value->get<std::string>()};
    return source;
  }
  const JsonObject object = from.child(key, *value, map_keys({"value"}));
  if (const auto column = object.text("column")) {
    source.columns = {*column};
  }
  if (object.find("quaternion") != nullptr) {
    source.columns = read_texts(object, "quaternion");
    if (source.columns.size() != 4 || object.find("column") != nullptr ||
        name != pose_columns().back()) {
      from.reject(key, *value, "of a yaw, a quaternion of four columns x, y, z, w and no column");
    }
  } else if (source.columns.empty() && value->is_object()) {
    from.reject(key, *value, "a column or a quaternion");
  }
  if (source.is_quaternion() &&
      (object.find("unit") != nullptr || object.find("scale") != nullptr)) {
    from.reject(key, *value, "a quaternion without a unit or a scale: it gives radians");
  }
  read_scale(object, name, source.scale);
  source.add = object.number("add").value_or(0.0);
  return source;
}

TimeSource read_time(const JsonObject& stream) {
  TimeSource time;
  const nlohmann::json* value = stream.find("time");
  if (value == nullptr) {
    return time;
  }
  if (value->is_string()) {
    time.columns = {value->get<std::string>()};
    return time;
  }
  const JsonObject object = stream.child("time", *value, map_keys({"time"}));
  const nlohmann::json* column = object.find("column");
  if (column != nullptr && column->is_string()) {
    time.columns = {column->get<std::string>()};
  } else if (column != nullptr) {
    time.columns = read_texts(object, "column");
    if (time.columns.size() != 2) {
      object.reject("column", *column, "a column, or two of seconds and nanoseconds");
    }
  }
  if (const nlohmann::json* unit = object.find("unit")) {
    const std::string word = unit->is_string() ? unit->get<std::string>() : "";
    time.dates = word == "iso";
    time.unit = table::time_unit_of_word(word);
    if (!time.dates && !time.unit) {
      object.reject("unit", *unit, "s, ms, us, ns or iso");
    } else if (time.columns.size() == 2) {
      object.reject("unit", *unit, "no unit: the columns are of seconds and of nanoseconds");
    }
  }
  if (const nlohmann::json* origin = object.find("origin")) {
    time.from_first = *origin == "first";
    if (!time.from_first) {
      object.reject("origin", *origin, "\"first\"");
    }
  }
  return time;
}

}  // namespace tcert::recording
