#pragma once
/// \file
/// Which program this is, by its bytes.

#include <string>

namespace tcert::cli {

/// SHA-256 of this program's file: results of another build are not used for its own.
[[nodiscard]] const std::string& program_digest();

}  // namespace tcert::cli
