#pragma once
/// \file
/// The files of a bundle, whether they lie in a folder or in a .zip.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <vector>

struct zip;

namespace tcert {

/// Reads files by their name in the bundle, such as "logs/t1/pose.csv". In a .zip they may all lie
/// in one folder, as zip programs make it. One thread at a time; open it once per thread.
class BundleFiles {
 public:
  /// Never throws on what it finds: see problem(). \throws OutOfResources.
  explicit BundleFiles(std::filesystem::path path);
  ~BundleFiles();
  BundleFiles(const BundleFiles&) = delete;
  BundleFiles& operator=(const BundleFiles&) = delete;

  /// Why the bundle cannot be opened; empty if it can.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

  [[nodiscard]] bool contains(const std::string& name) const;

  /// `name`, `name`.gz or `name`.zst, whichever is there first.
  [[nodiscard]] std::optional<std::string> find(const std::string& name) const;

  /// Of every file, sorted; links to files and folders are followed. A folder that is nested more
  /// than 32 levels deep is a problem(), as one that links to itself would be. \pre problem() is
  /// empty.
  [[nodiscard]] std::vector<std::string> names();

  /// The bytes of a file as they are. \pre problem() is empty.
  [[nodiscard]] table::BytesResult read_raw(const std::string& name) const;

  /// The text of a file, expanded if it is compressed. \pre problem() is empty.
  [[nodiscard]] table::BytesResult read(const std::string& name) const;

 private:
  [[nodiscard]] table::BytesResult read_from_archive(const std::string& name) const;

  std::filesystem::path path_;
  std::shared_ptr<struct ::zip> archive_;  // none for a folder; shared within a thread
  std::string prefix_;                     // of every name in the archive
  std::string problem_;
};

}  // namespace tcert
