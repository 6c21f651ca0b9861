#pragma once
/// \file
/// Structs of the C interface that may grow: each begins with struct_size, its size where the
/// caller was compiled. Members are only ever appended, so that the struct of an older caller is
/// the beginning of ours.

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace tcert {

/// Bytes of `Struct` that every caller has: up to the end of the last member of its first version,
/// without what the compiler pads. To be specialised.
template <typename Struct>
inline constexpr std::size_t kFirstSize = sizeof(Struct);

/// True for any version that this library has known; false for a caller newer than the library, and
/// for a size that no version has: members are of 4 bytes or more.
template <typename Struct>
[[nodiscard]] bool is_known_size(std::uint32_t size) noexcept {
  return size >= kFirstSize<Struct> && size <= sizeof(Struct) && size % sizeof(std::uint32_t) == 0;
}

/// What a caller gave, with `missing` for the members that it does not have.
/// \pre is_known_size<Struct>(given.struct_size).
template <typename Struct>
[[nodiscard]] Struct completed(const Struct& given, const Struct& missing = {}) noexcept {
  Struct whole = missing;
  std::memcpy(static_cast<void*>(&whole), &given, given.struct_size);
  whole.struct_size = sizeof whole;
  return whole;
}

/// Writes of `whole` what the caller has room for; out.struct_size stays. \pre as above.
template <typename Struct>
void give(const Struct& whole, Struct& out) noexcept {
  const std::uint32_t size = out.struct_size;
  std::memcpy(static_cast<void*>(&out), &whole, size);
  out.struct_size = size;
}

}  // namespace tcert
