#pragma once
/// \file
/// The words by which the flags of a tick are known in files and messages.

#include <cstdint>

namespace tcert {

/// "stale", "bad_input", ... for one TickFlag; "" for anything else.
[[nodiscard]] const char* flag_word(std::uint32_t flag) noexcept;

}  // namespace tcert
