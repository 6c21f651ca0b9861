#pragma once
/// \file
/// `tcert calibrate`, one function per kind.

#include "cli/commands/command.hpp"

namespace tcert::cli {

/// Arguments with the kind among them. Return the exit code; throw the errors of errors.hpp.
int calibrate_guards_command(Arguments arguments);
int calibrate_rays_command(Arguments arguments);
int calibrate_tracking_command(Arguments arguments);

/// What they take.
[[nodiscard]] CommandForm calibrate_guards_form();
[[nodiscard]] CommandForm calibrate_rays_form();
[[nodiscard]] CommandForm calibrate_tracking_form();

}  // namespace tcert::cli
