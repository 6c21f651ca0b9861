#pragma once
/// \file
/// `live terrain`, a form of `live`.

#include "cli/commands/command_line.hpp"

namespace tcert::cli {

int live_terrain_command(Arguments arguments);
[[nodiscard]] CommandForm live_terrain_form();

}  // namespace tcert::cli
