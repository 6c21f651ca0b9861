#pragma once
/// \file
/// Reading a JSON object strictly: every key is known, every value has its type, all problems at
/// once.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert::table {

/// Parses `text`; a syntax error and a key given twice are errors, and then there is no value.
[[nodiscard]] std::optional<nlohmann::json> parse_json(std::string_view text,
                                                       const std::string& file,
                                                       DiagnosticGroups& problems);

/// A view of one object of a JSON document. Getters return nothing for a key that is absent or
/// whose value is wrong; the latter is reported under its path, such as "robot.body_width_m".
class JsonObject {
 public:
  /// Reports keys that are not in `known`, with the nearest that is. A value that is not an object
  /// is reported and taken for an empty one.
  JsonObject(const nlohmann::json& value,
             std::string path,
             const std::vector<std::string>& known,
             std::string file,
             DiagnosticGroups& problems);

  /// The object at `value`, which lies under `key` of this one.
  [[nodiscard]] JsonObject child(std::string_view key,
                                 const nlohmann::json& value,
                                 const std::vector<std::string>& known) const;

  [[nodiscard]] const nlohmann::json* find(const std::string& key) const;
  [[nodiscard]] const nlohmann::json* require(const std::string& key) const;

  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  [[nodiscard]] std::optional<double> required_number(const std::string& key) const;
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const;
  [[nodiscard]] std::optional<bool> boolean(const std::string& key) const;

  [[nodiscard]] std::string path_of(std::string_view key) const;

  /// A list whose entries all satisfy `is_entry`; null if absent or, reported, something else.
  [[nodiscard]] const nlohmann::json* list(const std::string& key,
                                           bool (*is_entry)(const nlohmann::json&),
                                           const std::string& expectation) const;

  /// Reports a value that is not `expectation`.
  void reject(std::string_view key,
              const nlohmann::json& value,
              const std::string& expectation) const;

  [[nodiscard]] DiagnosticGroups& problems() const noexcept { return *problems_; }

 private:
  const nlohmann::json* object_ = nullptr;  // null if the value was not an object
  std::string path_;
  std::string file_;
  DiagnosticGroups* problems_;
};

/// `value` as text on one line, shortened.
[[nodiscard]] std::string shown(const nlohmann::json& value);

}  // namespace tcert::table
