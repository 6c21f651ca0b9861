#pragma once
/// \file
/// The checksum of an MCAP file's data section, gathered while it is read.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "datasets/import/file_window.hpp"

namespace tcert::recording {

/// Sums what is added to it, in the order of the file; nothing where no sum is wanted.
class DataChecksum {
 public:
  explicit DataChecksum(bool wanted) noexcept : wanted_(wanted) {}

  [[nodiscard]] bool wanted() const noexcept { return wanted_; }
  [[nodiscard]] std::uint32_t value() const noexcept { return value_; }

  void add(std::span<const std::byte> bytes) noexcept;

  /// `record`, in which `part` lies, whose own checksum is `part_crc`: it is not summed again.
  void add(std::span<const std::byte> record,
           std::span<const std::byte> part,
           std::uint32_t part_crc) noexcept;

  /// `length` bytes of the file from `offset` on.
  void add(FileWindow& window, std::uint64_t offset, std::uint64_t length);

 private:
  bool wanted_;
  std::uint32_t value_ = 0;
};

/// The checksum that the file says its data section has; 0 if it says none. Found from the footer,
/// before the section is read.
[[nodiscard]] std::uint32_t said_data_crc(FileWindow& window);

/// "0x1234abcd"
[[nodiscard]] std::string crc_text(std::uint32_t crc);

}  // namespace tcert::recording
