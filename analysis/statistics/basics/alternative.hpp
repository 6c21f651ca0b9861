#pragma once
/// \file
/// One- and two-sided tests.

#include <cstdint>

namespace tcert::statistics {

/// Which differences speak against "no difference".
enum class Alternative : std::uint8_t { two_sided, less, greater };

}  // namespace tcert::statistics
