#pragma once
/// \file
/// A place in the bytes of a CDR message, and what can be taken there.

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace tcert::recording {

static_assert(std::endian::native == std::endian::little);

/// The bytes of a value in the other order.
template <class T>
[[nodiscard]] T swapped(T value) noexcept {
  if constexpr (sizeof(T) == 2) {
    return std::bit_cast<T>(__builtin_bswap16(std::bit_cast<std::uint16_t>(value)));
  } else if constexpr (sizeof(T) == 4) {
    return std::bit_cast<T>(__builtin_bswap32(std::bit_cast<std::uint32_t>(value)));
  } else if constexpr (sizeof(T) == 8) {
    return std::bit_cast<T>(__builtin_bswap64(std::bit_cast<std::uint64_t>(value)));
  } else {
    return value;
  }
}

/// Takes values off `body`, each aligned to the smaller of its size and `alignment`, counted from
/// the beginning of `body`. After the first thing that does not fit every take is false.
class CdrCursor {
 public:
  CdrCursor(std::span<const std::byte> body, std::size_t alignment, bool swap) noexcept
      : body_(body), alignment_(alignment), swap_(swap) {}

  [[nodiscard]] std::size_t left() const noexcept { return body_.size() - at_; }

  template <class T>
  [[nodiscard]] bool take(T& value) noexcept {
    align(sizeof(T));
    if (left() < sizeof(T)) {
      return fail();
    }
    std::memcpy(&value, body_.data() + at_, sizeof(T));
    value = swap_ ? swapped(value) : value;
    at_ += sizeof(T);
    return true;
  }

  /// `count` values of type Wire into `out`, which is given that size once they are known to be
  /// there.
  template <class Wire, class Wide>
  [[nodiscard]] bool take_many(std::size_t count, std::vector<Wide>& out) {
    if (count > 0) {
      align(sizeof(Wire));
    }
    if (count > left() / sizeof(Wire)) {
      return fail();
    }
    out.resize(count);
    const std::byte* from = body_.data() + at_;
    if constexpr (std::is_same_v<Wire, Wide>) {
      if (count > 0) {
        std::memcpy(out.data(), from, count * sizeof(Wire));
      }
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        Wire value{};
        std::memcpy(&value, from + i * sizeof(Wire), sizeof(Wire));
        // NOLINTNEXTLINE(bugprone-signed-char-misuse): an int8 keeps its sign.
        out[i] = static_cast<Wide>(swap_ ? swapped(value) : value);
      }
    }
    if (std::is_same_v<Wire, Wide> && sizeof(Wire) > 1 && swap_) {
      std::ranges::transform(out, out.begin(), [](Wide value) { return swapped(value); });
    }
    at_ += count * sizeof(Wire);
    return true;
  }

  [[nodiscard]] bool take_text(std::size_t length, std::string& out) {
    if (length > left()) {
      return fail();
    }
    out.assign(reinterpret_cast<const char*>(body_.data() + at_), length);
    at_ += length;
    return true;
  }

 private:
  void align(std::size_t size) noexcept {
    const std::size_t to = std::min(size, alignment_);
    at_ = std::min(body_.size(), (at_ + to - 1) / to * to);
  }

  bool fail() noexcept {
    at_ = body_.size();
    return false;
  }

  std::span<const std::byte> body_;
  std::size_t alignment_;
  bool swap_;
  std::size_t at_ = 0;
};

}  // namespace tcert::recording
