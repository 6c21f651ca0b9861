#pragma once
/// \file
/// CRC-32 of ISO 3309, as zlib, PNG and MCAP have it, at the speed of memory where the processor
/// multiplies without carries.

#include <cstddef>
#include <cstdint>
#include <span>

namespace tcert::recording {

/// Of `bytes` behind those whose CRC is `before` (0: none).
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes,
                                  std::uint32_t before = 0) noexcept;

/// Of a text whose first part has the CRC `first` and whose second, of `length` bytes, `second`.
[[nodiscard]] std::uint32_t crc32_of_both(std::uint32_t first,
                                          std::uint32_t second,
                                          std::size_t length) noexcept;

}  // namespace tcert::recording
