#pragma once
/// \file
/// What the exit codes mean, once for the help and the manual.

#include <span>
#include <string_view>

namespace tcert::cli {

struct ExitMeaning {
  std::string_view codes;  ///< "4 to 8".
  std::string_view meaning;
};

[[nodiscard]] std::span<const ExitMeaning> exit_meanings();

}  // namespace tcert::cli
