#pragma once
/// \file
/// The walk through a message along its type, for CDR and for ROS 1.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "datasets/import/cdr_cursor.hpp"
#include "datasets/import/message_type.hpp"
#include "datasets/import/value.hpp"

namespace tcert::recording {

/// How the same types are laid out in bytes.
struct WireRules {
  std::size_t alignment = 8;        ///< Largest: 8 in XCDR1, 4 in XCDR2, 1 in ROS 1.
  bool swap = false;                ///< Big endian.
  bool ends_text_with_zero = true;  ///< And counts it.
  bool fills_empty = true;          ///< An empty structure has one byte.
  bool delimits_arrays = false;     ///< A byte count before arrays of what is no number (XCDR2).
  std::size_t wide_character = 4;   ///< Bytes of a character of a wstring.
  std::size_t padding = 3;          ///< Bytes that may be left behind the message.
};

/// A message longer than this, or of more values (packed numbers not counted), is refused.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20U;
inline constexpr std::size_t kMostValues = 2'000'000;

/// The value of `body` by `type`. \returns false, with the reason, if the bytes do not fit.
[[nodiscard]] bool read_message(const MessageType& type,
                                std::span<const std::byte> body,
                                const WireRules& rules,
                                Value& out,
                                std::string& problem);

}  // namespace tcert::recording
