#pragma once
/// \file
/// One- and two-sided tests.

#include <cstdint>

namespace tcert {

/// Which differences speak against "no difference".
enum class Alternative : std::uint8_t { two_sided, less, greater };

}  // namespace tcert
