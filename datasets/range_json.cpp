#include "datasets/range_json.hpp"

#include <cmath>
#include <string>

namespace tcert {
namespace {

constexpr std::size_t kMostValues = 16;

bool is_value(const nlohmann::json& value) { return value.is_number() || value == "inf"; }

std::vector<double> read_no_return(const table::JsonObject& ray) {
  const std::string expectation = R"(a list of at most 16 numbers and "inf")";
  std::vector<double> values;
  const nlohmann::json* list = ray.list("no_return", is_value, expectation);
  if (list == nullptr) {
    return values;
  }
  if (list->size() > kMostValues) {
    ray.reject("no_return", *list, expectation);
    return values;
  }
  for (const nlohmann::json& value : *list) {
    if (value.is_number()) {  // inf is nothing within reach without being declared
      values.push_back(value.get<double>());
    }
  }
  return values;
}

}  // namespace

RangeKeys read_range_keys(const table::JsonObject& ray, RayKind kind) {
  RangeKeys keys;
  if (kind != RayKind::range) {
    for (const char* key : {"no_return", "range_min_m", "range_max_m"}) {
      if (const nlohmann::json* value = ray.find(key)) {
        ray.reject(key, *value, "none: only a ray of kind range reads ranges");
      }
    }
    return keys;
  }
  keys.no_return = read_no_return(ray);
  keys.range_min_m = ray.number("range_min_m").value_or(keys.range_min_m);
  keys.range_max_m = ray.number("range_max_m").value_or(keys.range_max_m);
  if (keys.range_min_m < 0.0) {
    ray.reject("range_min_m", keys.range_min_m, "a number from 0");
  }
  if (!(keys.range_max_m > keys.range_min_m)) {
    ray.reject(
        "range_max_m", keys.range_max_m, "a number above range_min_m, which is 0 by default");
  }
  return keys;
}

void add_range_keys(const RangeKeys& keys, nlohmann::ordered_json& ray) {
  if (!keys.no_return.empty()) {
    ray["no_return"] = keys.no_return;
  }
  if (keys.range_min_m > 0.0) {
    ray["range_min_m"] = keys.range_min_m;
  }
  if (std::isfinite(keys.range_max_m)) {
    ray["range_max_m"] = keys.range_max_m;
  }
}

}  // namespace tcert
