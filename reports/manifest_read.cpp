#include "reports/manifest_read.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <table/bytes.hpp>
#include <table/json_shape.hpp>

#include "reports/manifest_checks.hpp"

namespace tcert {
namespace {

using Json = nlohmann::ordered_json;

ManifestFile file_of(const Json& json) {
  return {json.at("path").get<std::string>(),
          {json.at("files").get<std::uint64_t>(),
           json.at("bytes").get<std::uint64_t>(),
           json.at("sha256").get<std::string>()}};
}

std::vector<ManifestFile> files_of(const Json& json) {
  std::vector<ManifestFile> files;
  for (const Json& one : json) {
    files.push_back(file_of(one));
  }
  return files;
}

/// As text again: a number in its shortest form, null as nothing.
Settings settings_of(const Json& json) {
  Settings settings;
  for (const auto& [key, value] : json.items()) {
    settings.emplace_back(key,
                          value.is_string() ? value.get<std::string>()
                          : value.is_null() ? std::string()
                                            : value.dump());
  }
  return settings;
}

std::optional<std::vector<ManifestArgument>> arguments_of(const Json& json) {
  if (!json.contains("arguments")) {
    return std::nullopt;
  }
  std::vector<ManifestArgument> arguments;
  for (const Json& one : json.at("arguments")) {
    if (one.is_object()) {
      arguments.push_back({one.at("input").get<std::string>(), true});
    } else {
      arguments.push_back({one.get<std::string>(), false});
    }
  }
  return arguments;
}

WrittenResult written_of(const Json& json) {
  WrittenResult written;
  written.command = json.at("command").get<std::string>();
  written.arguments = arguments_of(json);
  written.tool_version = json.at("tool").at("version").get<std::string>();
  written.tool_commit = json.at("tool").at("commit").get<std::string>();
  if (json.at("synthetic").get<bool>()) {
    written.synthetic.emplace();
    if (!json.at("synthetic_seed").is_null()) {
      written.synthetic->seed = json.at("synthetic_seed").get<std::uint64_t>();
    }
  }
  if (!json.at("seed").is_null()) {
    written.seed = json.at("seed").get<std::uint64_t>();
  }
  written.options = settings_of(json.at("options"));
  written.parameters = settings_of(json.at("parameters"));
  written.inputs = files_of(json.at("inputs"));
  written.outputs = files_of(json.at("outputs"));
  return written;
}

}  // namespace

std::string_view to_string(FileChange change) noexcept {
  switch (change) {
    case FileChange::added:
      return "was added";
    case FileChange::changed:
      return "was changed";
    case FileChange::missing:
      return "is missing";
  }
  return "";
}

std::optional<WrittenResult> read_manifest(const std::filesystem::path& path) {
  const table::BytesResult file = table::read_raw_file(path);
  if (!file.bytes || !table::json_shape_problem(file.bytes->view()).empty()) {
    return std::nullopt;
  }
  const Json json = Json::parse(file.bytes->view(), nullptr, false);
  try {
    if (!json.is_object() || json.at("format") != "tcert-manifest") {
      return std::nullopt;
    }
    return written_of(json);
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::string why_no_manifest(const std::filesystem::path& path) {
  const table::BytesResult file = table::read_raw_file(path);
  std::string words = "'" + path.string() + "' is not a manifest of this tool";
  if (!file.bytes) {
    words += ": " + file.problem;
  } else if (const auto shape = table::json_shape_problem(file.bytes->view()); !shape.empty()) {
    words += ": ";
    words += shape;
  }
  return words;
}

bool is_as_written(const std::filesystem::path& path, const WrittenResult& written) {
  if (!written.arguments) {
    return true;
  }
  Manifest manifest;
  manifest.command = written.command;
  manifest.arguments = *written.arguments;
  manifest.options = written.options;
  manifest.parameters = written.parameters;
  manifest.seed = written.seed;
  manifest.synthetic = written.synthetic;
  manifest.inputs = written.inputs;
  manifest.outputs = written.outputs;
  const table::BytesResult file = table::read_raw_file(path);
  return file.bytes &&
         file.bytes->view() == to_json(manifest, written.tool_version, written.tool_commit);
}

std::vector<std::string> strange_entries(const std::filesystem::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_symlink() || !(entry.is_directory() || entry.is_regular_file())) {
      found.push_back(entry.path().lexically_relative(folder).generic_string());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<FileDifference> differences(const std::filesystem::path& folder,
                                        const WrittenResult& written) {
  std::map<std::string, FileDigest> listed;
  for (const ManifestFile& file : written.outputs) {
    listed.emplace(file.path, file.digest);
  }
  std::vector<FileDifference> found;
  for (std::string& entry : strange_entries(folder)) {
    found.push_back({std::move(entry), FileChange::added});
  }
  for (const ManifestFile& file : folder_outputs(folder)) {
    if (file.path == "manifest.json") {
      continue;
    }
    const auto entry = listed.find(file.path);
    if (entry == listed.end()) {
      found.push_back({file.path, FileChange::added});
      continue;
    }
    if (entry->second.files != file.digest.files || entry->second.sha256 != file.digest.sha256) {
      found.push_back({file.path, FileChange::changed});
    }
    listed.erase(entry);
  }
  for (const auto& [path, digest] : listed) {
    found.push_back({path, FileChange::missing});
  }
  std::sort(found.begin(), found.end(), [](const FileDifference& a, const FileDifference& b) {
    return a.path < b.path;
  });
  return found;
}

std::optional<std::string> first_difference(const std::filesystem::path& folder,
                                            const WrittenResult& written) {
  const std::vector<FileDifference> found = differences(folder, written);
  return found.empty() ? std::nullopt : std::optional(found.front().path);
}

}  // namespace tcert
