#pragma once
/// \file
/// What this machine computes with: the C library takes other versions of exp and the like on other
/// processors, which may differ in the last bit.

#include <string>

namespace tcert::cli {

/// Digest of what every function of the C library that studies call gives at many points. Machines
/// with the same digest give a study the same bytes; O(1), about a millisecond.
[[nodiscard]] const std::string& arithmetic_digest();

}  // namespace tcert::cli
