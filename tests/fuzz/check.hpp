#pragma once
/// \file
/// Properties that a fuzz target asserts, in every build type.

#include <cstdio>
#include <cstdlib>

namespace tcert::fuzz {

/// Ends the process, so that the fuzzer keeps the input, unless `holds`.
inline void require(bool holds, const char* property) {
  if (!holds) {
    std::fprintf(stderr, "violated: %s\n", property);
    std::abort();
  }
}

}  // namespace tcert::fuzz
