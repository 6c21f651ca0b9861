#pragma once
/// \file
/// A file of any length, of which a part is in memory.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace tcert::recording {

/// Bytes that are not initialised, and whose room only grows.
class Buffer {
 public:
  /// Room for `size` bytes; what was in it is lost if it has to grow, and its first `kept` bytes
  /// are not. \throws table::OutOfResources.
  std::span<std::byte> room(std::size_t size, std::size_t kept = 0);

  void release() noexcept;

 private:
  std::unique_ptr<std::byte[]> data_;  // NOLINT(modernize-avoid-c-arrays): uninitialised on purpose
  std::size_t capacity_ = 0;
};

/// Reads a regular file front to back, by copies and not by mapping: what is in memory is one
/// piece, and a file that somebody cuts off meanwhile ends instead of raising a signal. Movable.
class FileWindow {
 public:
  /// Nothing, with the reason, if `path` is no regular file or cannot be read.
  /// \throws table::OutOfResources.
  [[nodiscard]] static std::optional<FileWindow> open(const std::filesystem::path& path,
                                                      std::string& problem);
  ~FileWindow();
  FileWindow(FileWindow&& other) noexcept;
  FileWindow& operator=(FileWindow&&) = delete;
  FileWindow(const FileWindow&) = delete;
  FileWindow& operator=(const FileWindow&) = delete;

  /// Bytes of the file when it was opened.
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }

  /// `length` bytes from `offset` on; fewer only at the end of the file. Valid until the next call.
  /// \throws table::OutOfResources.
  [[nodiscard]] std::span<const std::byte> at(std::uint64_t offset, std::size_t length);

  /// Gives the memory back; the next at() takes it again.
  void release() noexcept;

 private:
  FileWindow(int descriptor, std::uint64_t size) noexcept;
  [[nodiscard]] std::size_t read(std::uint64_t offset, std::span<std::byte> to) const noexcept;

  int descriptor_;
  std::uint64_t size_;
  Buffer buffer_;
  std::span<std::byte> held_;  // in buffer_
  std::uint64_t begin_ = 0;    // of held_, in the file
};

}  // namespace tcert::recording
