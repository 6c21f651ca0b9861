#include "cli/runs/verify/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "reports/manifest_checks.hpp"

namespace tcert::cli {
namespace {

namespace fs = std::filesystem;

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && !entry.is_symlink()) {
      files.insert(entry.path().lexically_relative(folder).generic_string());
    }
  }
  files.erase("manifest.json");
  return files;
}

const std::string* value_of(const Settings& settings, const std::string& key) {
  for (const auto& [name, value] : settings) {
    if (name == key) {
      return &value;
    }
  }
  return nullptr;
}

std::string in_words(const std::string* value) {
  return value == nullptr ? "not there" : "'" + *value + "'";
}

void compare_settings(const std::string& kind,
                      const Settings& found,
                      const Settings& again,
                      std::vector<std::string>& differences) {
  std::set<std::string> keys;
  for (const Settings* const settings : {&found, &again}) {
    for (const auto& [key, value] : *settings) {
      keys.insert(key);
    }
  }
  for (const std::string& key : keys) {
    const std::string* const then = value_of(found, key);
    const std::string* const now = value_of(again, key);
    if (then == nullptr || now == nullptr || *then != *now) {
      differences.push_back(fmt::format("its manifest has the {} {} as {}, but made again it is {}",
                                        kind,
                                        key,
                                        in_words(then),
                                        in_words(now)));
    }
  }
}

const ManifestFile* file_called(const std::vector<ManifestFile>& files, const std::string& path) {
  const auto file = std::find_if(
      files.begin(), files.end(), [&](const ManifestFile& one) { return one.path == path; });
  return file == files.end() ? nullptr : &*file;
}

bool same(const FileDigest& a, const FileDigest& b) {
  return a.files == b.files && a.bytes == b.bytes && a.sha256 == b.sha256;
}

void compare_inputs(const WrittenResult& found,
                    const WrittenResult& again,
                    std::vector<std::string>& differences) {
  for (const ManifestFile& input : found.inputs) {
    const ManifestFile* const now = file_called(again.inputs, input.path);
    if (now == nullptr || !same(input.digest, now->digest)) {
      differences.push_back("its input '" + input.path + "' has changed since");
    }
  }
  for (const ManifestFile& input : again.inputs) {
    if (file_called(found.inputs, input.path) == nullptr) {
      differences.push_back("its manifest does not list the input '" + input.path + "'");
    }
  }
}

void compare_outputs(const WrittenResult& found,
                     const WrittenResult& again,
                     std::vector<std::string>& differences) {
  for (const ManifestFile& output : again.outputs) {
    const ManifestFile* const then = file_called(found.outputs, output.path);
    if (then == nullptr) {
      differences.push_back("its manifest does not list '" + output.path + "'");
    } else if (!same(then->digest, output.digest)) {
      differences.push_back("its manifest has another digest of '" + output.path +
                            "' than what is made again");
    }
  }
  for (const ManifestFile& output : found.outputs) {
    if (file_called(again.outputs, output.path) == nullptr) {
      differences.push_back("its manifest lists '" + output.path + "', which is not made again");
    }
  }
}

std::string seed_in_words(const std::optional<std::uint64_t>& seed) {
  return seed ? std::to_string(*seed) : "none";
}

std::string origin_in_words(const std::optional<SyntheticLabel>& label) {
  return label ? "synthetic, seed " + seed_in_words(label->seed) : "not synthetic";
}

}  // namespace

std::vector<std::string> compare_folders(const fs::path& found, const fs::path& again) {
  const std::set<std::string> first = files_in(found);
  const std::set<std::string> second = files_in(again);
  std::vector<std::string> differences;
  for (const std::string& entry : strange_entries(found)) {
    differences.push_back("'" + entry + "' is a link or another thing that no result holds");
  }
  for (const std::string& file : second) {
    if (!first.contains(file)) {
      differences.push_back("'" + file + "' is missing");
    } else if (digest_file(found / file).sha256 != digest_file(again / file).sha256) {
      differences.push_back("'" + file + "' is not what is made again");
    }
  }
  for (const std::string& file : first) {
    if (!second.contains(file)) {
      differences.push_back("'" + file + "' is not made again");
    }
  }
  return differences;
}

std::vector<std::string> compare_manifests(const WrittenResult& found, const WrittenResult& again) {
  std::vector<std::string> differences;
  compare_inputs(found, again, differences);
  compare_settings("parameter", found.parameters, again.parameters, differences);
  compare_settings("option", found.options, again.options, differences);
  if (found.seed != again.seed) {
    differences.push_back("its manifest has the seed " + seed_in_words(found.seed) +
                          ", but made again it is " + seed_in_words(again.seed));
  }
  if (origin_in_words(found.synthetic) != origin_in_words(again.synthetic)) {
    differences.push_back("its manifest calls the data " + origin_in_words(found.synthetic) +
                          ", but made again they are " + origin_in_words(again.synthetic));
  }
  compare_outputs(found, again, differences);
  return differences;
}

}  // namespace tcert::cli
