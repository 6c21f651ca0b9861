#pragma once
/// \file
/// SHA-256 of bytes, files and folders (OpenSSL).

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace tcert {

/// Digest of bytes that come in pieces.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&& other) noexcept;
  Sha256& operator=(Sha256&& other) noexcept;
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void update(std::string_view bytes);

  /// 64 hexadecimal digits, lower case; afterwards the digest starts anew.
  [[nodiscard]] std::string finish();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

[[nodiscard]] std::string sha256(std::string_view bytes);

/// What a file, or all files of a folder, amount to.
struct FileDigest {
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
  std::string sha256;
};

/// Digest of a list of files, file by file: over the lines "<sha256>  <path>\n".
class ListDigest {
 public:
  void add(std::string_view path, const FileDigest& digest);

  [[nodiscard]] FileDigest finish();

 private:
  Sha256 lines_;
  FileDigest sum_;
};

/// Digest of the file's bytes. \throws std::system_error if it cannot be read.
[[nodiscard]] FileDigest digest_file(const std::filesystem::path& path);

/// Digest over the lines "<sha256>  <path relative to the folder>\n" of its regular files, sorted
/// by path in byte order: what `sha256sum` of the sorted files, piped into `sha256sum`, says.
/// \throws std::system_error if a file cannot be read.
[[nodiscard]] FileDigest digest_folder(const std::filesystem::path& folder);

/// digest_folder of a folder, digest_file of anything else.
[[nodiscard]] FileDigest digest_path(const std::filesystem::path& path);

}  // namespace tcert
