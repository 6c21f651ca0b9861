#pragma once
/// \file
/// A CDR message, written value by value.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace tcert::test_support {

/// Aligns each value to the smaller of its size and `alignment`, from behind the four header bytes.
class CdrBytes {
 public:
  explicit CdrBytes(std::uint8_t kind = 1) : alignment_(kind >= 6 ? 4 : 8), swaps_(kind % 2 == 0) {
    bytes_ = {'\0', static_cast<char>(kind), '\0', '\0'};
  }

  template <class T>
  CdrBytes& put(T value) {
    const std::size_t to = std::min(sizeof(T), alignment_);
    while ((bytes_.size() - 4) % to != 0) {
      bytes_ += '\0';
    }
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (swaps_) {
      std::reverse(raw, raw + sizeof(T));
    }
    bytes_.append(raw, sizeof(T));
    return *this;
  }

  CdrBytes& text(std::string_view value) {
    put(static_cast<std::uint32_t>(value.size() + 1));
    bytes_ += value;
    bytes_ += '\0';
    return *this;
  }

  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::size_t alignment_;
  bool swaps_;
  std::string bytes_;
};

}  // namespace tcert::test_support
