#pragma once
/// \file
/// `tcert assure`, one function per kind.

#include "cli/commands/command.hpp"

namespace tcert::cli {

/// Arguments with the kind among them. Return the exit code; throw the errors of errors.hpp.
int assure_monitor_command(Arguments arguments);
int assure_perturb_command(Arguments arguments);

/// What they take.
[[nodiscard]] CommandForm assure_monitor_form();
[[nodiscard]] CommandForm assure_perturb_form();

}  // namespace tcert::cli
