#pragma once
/// \file
/// `tcert calibrate`, one function per kind.

#include "cli/commands/command.hpp"

namespace tcert::cli {

/// Arguments with the kind among them. Returns the exit code; throws the errors of errors.hpp.
int calibrate_rays_command(Arguments arguments);

/// What it takes.
[[nodiscard]] CommandForm calibrate_rays_form();

}  // namespace tcert::cli
