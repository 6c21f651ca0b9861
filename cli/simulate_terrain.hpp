#pragma once
/// \file
/// `simulate terrain`: random fields with a stated Lipschitz constant.

#include "cli/command.hpp"

namespace tcert::cli {

/// Arguments after the word `terrain`. Returns the exit code.
[[nodiscard]] int simulate_terrain(Arguments arguments);

}  // namespace tcert::cli
