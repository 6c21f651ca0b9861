#pragma once
/// \file
/// Whole files in memory, decompressed on the way in.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace tcert::table {

/// Bytes of a file. A line feed and zeros follow the last byte, so that a scanner may look ahead
/// kPadding bytes and always meets a line end. Movable, not copyable.
class Bytes {
 public:
  static constexpr std::size_t kPadding = 16;

  Bytes() : Bytes(0) {}

  /// Room for `size` bytes, not initialised. \throws std::bad_alloc.
  explicit Bytes(std::size_t size);

  [[nodiscard]] static Bytes copy_of(std::string_view text);

  [[nodiscard]] std::string_view view() const noexcept { return {data_.get(), size_}; }
  [[nodiscard]] char* data() noexcept { return data_.get(); }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Keeps the first min(size, old size) bytes.
  void resize(std::size_t size);

  /// Replaces the contents; allocates only when `text` is longer than any before it.
  void assign(std::string_view text);

 private:
  void pad() noexcept;

  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
  std::unique_ptr<char[]> data_;  // NOLINT(modernize-avoid-c-arrays): uninitialised on purpose
};

struct BytesResult {
  std::optional<Bytes> bytes;
  std::string problem;  ///< Why there are none, fit to follow "expected a readable file: ".
};

enum class Compression { none, gzip, zstd };

/// By the first bytes, whatever the name ends in.
[[nodiscard]] Compression compression_of(std::string_view bytes) noexcept;

/// Expands gzip (several members too) or zstd (several frames too). Cut or damaged input and
/// contents of more than 4 GiB, or that are not is_plausible_expansion(), are a problem, not a
/// partial result. \throws OutOfResources.
[[nodiscard]] BytesResult decompress(Bytes packed, Compression compression);

/// Reads a regular file as it is on disk; a pipe or a device is a problem and not waited for. Never
/// throws on what it finds. \throws OutOfResources.
[[nodiscard]] BytesResult read_raw_file(const std::filesystem::path& path);

/// Reads a file and expands it if it is compressed.
[[nodiscard]] BytesResult read_file(const std::filesystem::path& path);

}  // namespace tcert::table
