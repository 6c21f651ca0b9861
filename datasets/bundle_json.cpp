#include "datasets/bundle_json.hpp"

#include <algorithm>
#include <table/json_object.hpp>
#include <utility>

#include "datasets/bundle_fields.hpp"
#include "datasets/robot_json.hpp"

namespace tcert {

namespace {

bool is_text(const nlohmann::json& value) { return value.is_string(); }

void check_format(const table::JsonObject& bundle) {
  if (const nlohmann::json* format = bundle.require("format");
      format != nullptr && *format != "tcert-bundle") {
    bundle.reject("format", *format, "\"tcert-bundle\"");
  }
  if (const nlohmann::json* version = bundle.require("version");
      version != nullptr && *version != 1) {
    bundle.reject("version", *version, "1");
  }
}

std::optional<double> read_positive(const table::JsonObject& bundle, const std::string& key) {
  const std::optional<double> value = bundle.number(key);
  if (value && !(*value > 0.0)) {
    bundle.reject(key, *value, "a number above 0");
    return std::nullopt;
  }
  return value;
}

StartAt read_start_at(const table::JsonObject& bundle) {
  const nlohmann::json* value = bundle.find("start_at");
  if (value != nullptr && *value != "both" && *value != "pose") {
    bundle.reject("start_at", *value, R"("both" or "pose")");
  }
  return value != nullptr && *value == "pose" ? StartAt::pose : StartAt::both;
}

std::optional<std::uint64_t> read_seed(const table::JsonObject& bundle) {
  const nlohmann::json* seed = bundle.find("seed");
  if (seed == nullptr) {
    return std::nullopt;
  }
  if (!seed->is_number_unsigned()) {
    bundle.reject("seed", *seed, "a whole number, 0 or more");
    return std::nullopt;
  }
  return seed->get<std::uint64_t>();
}

RangeKeys keys_of(const BundleInfo& info, std::size_t ray) {
  return ray < info.range_keys.size() ? info.range_keys[ray] : RangeKeys{};
}

std::map<std::string, std::map<std::string, std::string>> read_columns(
    const table::JsonObject& bundle) {
  const std::vector<std::string> files{
      "control.csv", "pose.csv", "tactile.csv", "ticks.csv", "trials.csv"};
  std::map<std::string, std::map<std::string, std::string>> columns;
  const nlohmann::json* value = bundle.find("columns");
  if (value == nullptr) {
    return columns;
  }
  const table::JsonObject from = bundle.child("columns", *value, files);
  for (const std::string& file : files) {
    const nlohmann::json* renames = from.find(file);
    if (renames == nullptr) {
      continue;
    }
    const bool all_texts =
        renames->is_object() && std::all_of(renames->begin(), renames->end(), is_text);
    if (all_texts) {
      columns[file] = renames->get<std::map<std::string, std::string>>();
    } else {
      from.reject(file, *renames, "an object of foreign column names and ours");
    }
  }
  return columns;
}

std::map<std::string, std::string> read_parameters(const table::JsonObject& bundle) {
  std::map<std::string, std::string> parameters;
  const nlohmann::json* value = bundle.find("parameters");
  if (value == nullptr) {
    return parameters;
  }
  if (!value->is_object()) {
    bundle.reject("parameters", *value, "an object {...}");
    return parameters;
  }
  for (const auto& [key, entry] : value->items()) {
    if (entry.is_string()) {
      parameters[key] = entry.get<std::string>();
    } else if (entry.is_number() || entry.is_boolean()) {
      parameters[key] = entry.dump();
    } else {
      bundle.reject("parameters." + key, entry, "a number, a text, true or false");
    }
  }
  return parameters;
}

BundleInfo read_info(const table::JsonObject& bundle) {
  check_format(bundle);
  BundleInfo info;
  info.synthetic = bundle.boolean("synthetic").value_or(false);
  info.seed = read_seed(bundle);
  info.provenance = bundle.text("provenance").value_or("");
  info.robot = read_robot(bundle, info.range_keys);
  info.course = read_course(bundle);
  if (const nlohmann::json* tiers = bundle.list("lighting", is_text, "a list of texts")) {
    info.lighting_tiers = tiers->get<std::vector<std::string>>();
  }
  info.trial_limit_s = read_positive(bundle, "trial_limit_s");
  info.max_gap_s = read_positive(bundle, "max_gap_s").value_or(info.max_gap_s);
  info.start_at = read_start_at(bundle);
  info.columns = read_columns(bundle);
  info.parameters = read_parameters(bundle);
  return info;
}

}  // namespace

std::optional<BundleInfo> parse_bundle_json(std::string_view text,
                                            table::DiagnosticGroups& problems) {
  const std::optional<nlohmann::json> document = table::parse_json(text, "bundle.json", problems);
  if (!document) {
    return std::nullopt;
  }
  const std::vector<std::string> keys = names_at("bundle.json", bundle_fields());
  BundleInfo info = read_info(table::JsonObject(*document, "", keys, "bundle.json", problems));
  if (problems.has_error()) {
    return std::nullopt;
  }
  return info;
}

std::string to_bundle_json(const BundleInfo& info) {
  nlohmann::ordered_json out{
      {"format", "tcert-bundle"}, {"version", 1}, {"synthetic", info.synthetic}};
  if (info.seed) {
    out["seed"] = *info.seed;
  }
  out["provenance"] = info.provenance;
  out["robot"] = {{"body_width_m", info.robot.body_width_m},
                  {"min_turn_radius_m", info.robot.min_turn_radius_m},
                  {"tracking_buffer_m", info.robot.tracking_buffer_m},
                  {"curvature_buffer_per_m", info.robot.curvature_buffer_per_m}};
  out["rays"] = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < info.robot.rays.size(); ++k) {
    out["rays"].push_back(ray_json(info.robot.rays[k], keys_of(info, k)));
  }
  if (info.course.start) {
    out["course"]["start"] = region_json(*info.course.start);
  }
  if (info.course.goal) {
    out["course"]["goal"] = region_json(*info.course.goal);
  }
  if (!info.lighting_tiers.empty()) {
    out["lighting"] = info.lighting_tiers;
  }
  if (info.trial_limit_s) {
    out["trial_limit_s"] = *info.trial_limit_s;
  }
  out["max_gap_s"] = info.max_gap_s;
  if (info.start_at == StartAt::pose) {
    out["start_at"] = "pose";
  }
  if (!info.columns.empty()) {
    out["columns"] = info.columns;
  }
  if (!info.parameters.empty()) {
    out["parameters"] = info.parameters;
  }
  return out.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace tcert
