#pragma once
/// \file
/// `tcert import`, one function per foreign format.

#include "cli/commands/command.hpp"

namespace tcert::cli {

/// Arguments with the format's name among them. Return the exit code; throw the errors of
/// errors.hpp.
int import_barn_command(Arguments arguments);
int import_carmen_command(Arguments arguments);
int import_log_command(Arguments arguments);

/// What they take.
[[nodiscard]] CommandForm import_barn_form();
[[nodiscard]] CommandForm import_carmen_form();
[[nodiscard]] CommandForm import_log_form();

}  // namespace tcert::cli
