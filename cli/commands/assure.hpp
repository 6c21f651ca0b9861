#pragma once
/// \file
/// `tcert assure`, one function per kind.

#include "cli/commands/command.hpp"

namespace tcert::cli {

/// Arguments with the kind among them. Returns the exit code; throws the errors of errors.hpp.
int assure_perturb_command(Arguments arguments);

/// What it takes.
[[nodiscard]] CommandForm assure_perturb_form();

}  // namespace tcert::cli
