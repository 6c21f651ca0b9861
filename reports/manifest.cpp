#include "reports/manifest.hpp"

#include <algorithm>

#include "reports/manifest_checks.hpp"
#include "reports/table_json.hpp"
#include "reports/version.hpp"

namespace tcert {
namespace {

using Json = OrderedJson;

Json json_settings(const Settings& settings) {
  Json json = Json::object();
  for (const auto& [key, value] : settings) {
    json[key] = setting_value(value);
  }
  return json;
}

Json json_files(const std::vector<ManifestFile>& files) {
  Json json = Json::array();
  for (const ManifestFile& file : files) {
    json.push_back({{"path", file.path},
                    {"files", file.digest.files},
                    {"bytes", file.digest.bytes},
                    {"sha256", file.digest.sha256}});
  }
  return json;
}

/// A word, or {"input": name}.
Json json_arguments(const std::vector<ManifestArgument>& arguments) {
  Json json = Json::array();
  for (const ManifestArgument& argument : arguments) {
    if (argument.is_input) {
      json.push_back({{"input", argument.text}});
    } else {
      json.push_back(argument.text);
    }
  }
  return json;
}

}  // namespace

std::string to_json(const Manifest& manifest) {
  return to_json(manifest, tool_version(), tool_commit());
}

std::string to_json(const Manifest& manifest, std::string_view version, std::string_view commit) {
  Json json;
  json["format"] = "tcert-manifest";
  json["version"] = 1;
  json["synthetic"] = manifest.synthetic.has_value();
  if (manifest.synthetic) {
    json["synthetic_seed"] =
        manifest.synthetic->seed ? Json(*manifest.synthetic->seed) : Json(nullptr);
  }
  json["tool"] = {{"name", "tcert"}, {"version", version}, {"commit", commit}};
  json["command"] = manifest.command;
  json["arguments"] = json_arguments(manifest.arguments);
  json["seed"] = manifest.seed ? Json(*manifest.seed) : Json(nullptr);
  json["options"] = json_settings(manifest.options);
  json["parameters"] = json_settings(manifest.parameters);
  json["inputs"] = json_files(manifest.inputs);
  json["outputs"] = json_files(manifest.outputs);
  return dumped(json, 2);
}

std::string name_of(const std::filesystem::path& path) {
  if (path.empty()) {
    return {};
  }
  return (std::filesystem::absolute(path) / "")
      .lexically_normal()
      .parent_path()
      .filename()
      .generic_string();
}

std::vector<ManifestFile> folder_outputs(const std::filesystem::path& folder) {
  std::vector<ManifestFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_symlink() || !(entry.is_directory() || entry.is_regular_file())) {
      continue;
    }
    const std::string name = entry.path().filename().generic_string();
    files.push_back({entry.is_directory() ? name + "/" : name, digest_path(entry.path())});
  }
  std::sort(files.begin(), files.end(), [](const ManifestFile& a, const ManifestFile& b) {
    return a.path < b.path;
  });
  return files;
}

}  // namespace tcert
