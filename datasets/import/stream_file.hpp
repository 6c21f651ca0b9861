#pragma once
/// \file
/// A CSV file of a stream of a bundle, written sample by sample.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tcert::recording {

/// The file is open only while it is written to, so that a bundle may have any number of them.
class StreamFile {
 public:
  /// With time_s before the `columns`. Missing folders are made. \throws table::WriteError.
  StreamFile(std::filesystem::path path, const std::vector<std::string>& columns);

  /// NaN is an empty cell. \pre as many values as columns. \throws table::WriteError.
  void add(std::int64_t time_ns, std::span<const double> values);

  /// All is in the file when this returns. \throws table::WriteError.
  void flush();

 private:
  std::filesystem::path path_;
  std::string text_;
};

}  // namespace tcert::recording
