#include "reports/manifest_read.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

namespace tcert {
namespace {

using Json = nlohmann::json;

ManifestFile file_of(const Json& json) {
  return {json.at("path").get<std::string>(),
          {json.at("files").get<std::uint64_t>(),
           json.at("bytes").get<std::uint64_t>(),
           json.at("sha256").get<std::string>()}};
}

}  // namespace

std::optional<WrittenResult> read_manifest(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const Json json = Json::parse(file, nullptr, false);
  try {
    if (!json.is_object() || json.at("format") != "tcert-manifest") {
      return std::nullopt;
    }
    WrittenResult written;
    written.command = json.at("command").get<std::string>();
    for (const Json& output : json.at("outputs")) {
      written.outputs.push_back(file_of(output));
    }
    return written;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::optional<std::string> first_difference(const std::filesystem::path& folder,
                                            const WrittenResult& written) {
  std::vector<ManifestFile> found = folder_outputs(folder);
  std::erase_if(found, [](const ManifestFile& file) { return file.path == "manifest.json"; });
  const auto same = [](const ManifestFile& a, const ManifestFile& b) {
    return a.path == b.path && a.digest.files == b.digest.files &&
           a.digest.sha256 == b.digest.sha256;
  };
  const auto first_not_in = [&](const std::vector<ManifestFile>& these,
                                const std::vector<ManifestFile>& those) {
    return std::find_if(these.begin(), these.end(), [&](const ManifestFile& file) {
      return std::none_of(
          those.begin(), those.end(), [&](const ManifestFile& other) { return same(file, other); });
    });
  };
  if (const auto file = first_not_in(found, written.outputs); file != found.end()) {
    return file->path;
  }
  if (const auto file = first_not_in(written.outputs, found); file != written.outputs.end()) {
    return file->path;
  }
  return std::nullopt;
}

}  // namespace tcert
