#include "datasets/import/log_map.hpp"

#include <algorithm>
#include <set>
#include <table/json_object.hpp>
#include <utility>

#include "datasets/bundle_fields.hpp"
#include "datasets/import/map_fields.hpp"
#include "datasets/import/map_streams.hpp"
#include "datasets/import/map_values.hpp"

namespace tcert::recording {
namespace {

using Json = nlohmann::json;
using table::JsonObject;

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
    const JsonObject object = trials.child(name, *value, map_keys({"success"}));
    outcome.column = object.require("column") == nullptr ? "" : object.text("column").value_or("");
    outcome.success_words = read_texts(object, "true");
    outcome.failure_words = read_texts(object, "false");
  } else {
    const JsonObject object = trials.child(name, *value, map_keys({"outcome"}));
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
  const JsonObject from = map.child("trials", *value, map_keys({"trials"}));
  if (const Json* split = from.find("split"); split != nullptr && *split != "file") {
    const JsonObject object = from.child("split", *split, map_keys({"split"}));
    source.column = object.require("column") == nullptr ? "" : object.text("column").value_or("");
  }
  source.table = from.text("table").value_or("");
  source.id = from.text("id").value_or("trial_id");
  const std::set<std::string_view> others{"split", "table", "id"};
  for (const std::string& key : map_keys({"trials"})) {
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
  static const std::vector<std::string> columns = map_keys({"pose"});
  return columns;
}

const std::vector<std::string>& control_columns() {
  static const std::vector<std::string> columns = map_keys({"control"});
  return columns;
}

std::optional<LogMap> parse_log_map(std::string_view text,
                                    const std::string& file,
                                    table::DiagnosticGroups& problems) {
  const std::optional<Json> document = table::parse_json(text, file, problems);
  if (!document) {
    return std::nullopt;
  }
  std::vector<std::string> keys = map_keys({"map"});
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
    log.pose = read_valued_stream(map, "pose", pose_columns());
  }
  log.rays = read_ray_streams(map);
  if (map.find("control") != nullptr) {
    log.control = read_valued_stream(map, "control", control_columns());
  }
  log.trials = read_trials(map);
  if (!log.trials.column.empty() &&
      (!log.pose.topic.empty() || log.pose.file.find("{trial}") != std::string::npos)) {
    map.reject("trials",
               log.document.value("trials", Json()),
               "no column of trials: each bag, each file of a pattern with {trial}, is a trial");
  }
  require_one_kind(map, log);
  for (const std::string& key : of_bundle) {
    if (const Json* value = map.find(key)) {
      log.bundle[key] = *value;
    }
  }
  return problems.has_error() ? std::nullopt : std::optional(std::move(log));
}

}  // namespace tcert::recording
