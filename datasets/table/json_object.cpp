#include <table/json_object.hpp>

#include <algorithm>
#include <set>
#include <table/json_shape.hpp>
#include <table/nearest_name.hpp>
#include <utility>
#include <vector>

namespace tcert::table {

namespace {

using nlohmann::json;

std::size_t line_at(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  return 1 + static_cast<std::size_t>(std::ranges::count(before, '\n'));
}

/// What the parser says, without its own name for it: "[json.exception...] parse error at ...:
/// what".
std::string reason_of(const json::exception& error) {
  const std::string_view message = error.what();
  const std::size_t colon = message.rfind(": ");
  return std::string(colon == std::string_view::npos ? message : message.substr(colon + 2));
}

/// Remembers the keys of the objects that are open, to find one that is given twice.
class KeyWatch {
 public:
  bool operator()(int /*depth*/, json::parse_event_t event, const json& parsed) {
    if (event == json::parse_event_t::object_start) {
      open_.emplace_back();
    } else if (event == json::parse_event_t::object_end) {
      open_.pop_back();
    } else if (event == json::parse_event_t::key) {
      const auto& key = parsed.get_ref<const std::string&>();
      if (!open_.back().insert(key).second) {
        repeated.push_back(key);
      }
    }
    return true;
  }

  std::vector<std::string> repeated;

 private:
  std::vector<std::set<std::string>> open_;
};

}  // namespace

std::optional<json> parse_json(std::string_view text,
                               const std::string& file,
                               DiagnosticGroups& problems) {
  KeyWatch watch;
  std::optional<json> value;
  if (const auto shape = json_shape_problem(text); !shape.empty()) {
    problems.add({Severity::error, file, 0, "", std::string(shape), "a JSON document", 1});
    return value;
  }
  try {
    value = json::parse(text, std::ref(watch));
  } catch (const json::parse_error& error) {
    problems.add({Severity::error,
                  file,
                  line_at(text, error.byte),
                  "",
                  shortened(reason_of(error)),
                  "a JSON document",
                  1});
  } catch (const json::exception& error) {
    problems.add({Severity::error, file, 0, "", shortened(reason_of(error)), "a JSON document", 1});
  }
  for (const std::string& key : watch.repeated) {
    problems.add({Severity::error, file, 0, shortened(key), "", "each key once", 1});
    value.reset();
  }
  return value;
}

JsonObject::JsonObject(const json& value,
                       std::string path,
                       const std::vector<std::string>& known,
                       std::string file,
                       DiagnosticGroups& problems)
    : path_(std::move(path)), file_(std::move(file)), problems_(&problems) {
  if (!value.is_object()) {
    problems_->add({Severity::error, file_, 0, path_, shown(value), "an object {...}", 1});
    return;
  }
  object_ = &value;
  for (const auto& [key, ignored] : value.items()) {
    if (std::ranges::find(known, key) != known.end()) {
      continue;
    }
    const auto nearest = nearest_name(key, known);
    problems_->add({Severity::error,
                    file_,
                    0,
                    path_of(shortened(key)),
                    "",
                    nearest ? "a known key; did you mean '" + *nearest + "'?" : "a known key",
                    1});
  }
}

std::string JsonObject::path_of(std::string_view key) const {
  std::string full = path_;
  full += full.empty() ? "" : ".";
  full += key;
  return full;
}

JsonObject JsonObject::child(std::string_view key,
                             const json& value,
                             const std::vector<std::string>& known) const {
  return {value, path_of(key), known, file_, *problems_};
}

const json* JsonObject::find(const std::string& key) const {
  if (object_ == nullptr) {
    return nullptr;
  }
  const auto found = object_->find(key);
  return found == object_->end() ? nullptr : &*found;
}

const json* JsonObject::require(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr && object_ != nullptr) {
    problems_->add({Severity::error, file_, 0, path_of(key), "", "this key to be given", 1});
  }
  return value;
}

void JsonObject::reject(std::string_view key,
                        const json& value,
                        const std::string& expectation) const {
  problems_->add({Severity::error, file_, 0, path_of(key), shown(value), expectation, 1});
}

std::optional<double> JsonObject::number(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_number()) {
    reject(key, *value, "a number");
    return std::nullopt;
  }
  return value->get<double>();
}

std::optional<double> JsonObject::required_number(const std::string& key) const {
  return require(key) == nullptr ? std::nullopt : number(key);
}

std::optional<std::string> JsonObject::text(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_string()) {
    reject(key, *value, "a text in quotes");
    return std::nullopt;
  }
  return value->get<std::string>();
}

std::optional<bool> JsonObject::boolean(const std::string& key) const {
  const json* value = find(key);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_boolean()) {
    reject(key, *value, "true or false");
    return std::nullopt;
  }
  return value->get<bool>();
}

const json* JsonObject::list(const std::string& key,
                             bool (*is_entry)(const json&),
                             const std::string& expectation) const {
  const json* value = find(key);
  if (value == nullptr || (value->is_array() && std::ranges::all_of(*value, is_entry))) {
    return value;
  }
  reject(key, *value, expectation);
  return nullptr;
}

std::string shown(const json& value) {
  return shortened(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

}  // namespace tcert::table
