#pragma once
/// \file
/// What a result was made from and with: manifest.json, written beside every output.
///
/// Nothing in it depends on the machine, the time of day or the number of threads, so that the same
/// inputs, options and seed give the same manifest, byte for byte.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/sha256.hpp"
#include "reports/table.hpp"

namespace tcert {

/// A file or folder that was read or written, with the name it is known by: relative, '/' between.
struct ManifestFile {
  std::string path;
  FileDigest digest;
};

/// Key and value, as text, in the order in which they are to appear.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A word of the command line that shapes the result, as far as it was given. Of an input only its
/// name is kept: where it lies is the machine's business.
struct ManifestArgument {
  std::string text;
  bool is_input = false;
  friend bool operator==(const ManifestArgument&, const ManifestArgument&) = default;
};

struct Manifest {
  std::string command;                      ///< "certify".
  std::vector<ManifestArgument> arguments;  ///< With them the command makes the result again.
  Settings options;                         ///< Options of the command with their effective values.
  Settings parameters;                      ///< Every parameter with its effective value.
  std::optional<std::uint64_t> seed;        ///< Of the draws the command made.
  std::optional<SyntheticLabel> synthetic;  ///< Of the data.
  std::vector<ManifestFile> inputs;
  std::vector<ManifestFile> outputs;
};

/// The JSON document, ended by a newline. Values that are numbers are written as numbers.
[[nodiscard]] std::string to_json(const Manifest& manifest);

/// Name of a file or folder without the machine's part of its path: its last component; of "."
/// that of the current folder. Empty for an empty path.
[[nodiscard]] std::string name_of(const std::filesystem::path& path);

/// The files of `folder` as outputs: each file on its own; a folder in it as one entry with its
/// count, bytes and digest (digest_folder), ended by '/'. Sorted by path. Links, pipes, sockets and
/// devices are left out.
[[nodiscard]] std::vector<ManifestFile> folder_outputs(const std::filesystem::path& folder);

}  // namespace tcert
