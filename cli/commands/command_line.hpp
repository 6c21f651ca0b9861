#pragma once
/// \file
/// The one way in which flags, arguments and config files are read into a request.

#include <string_view>
#include <vector>

#include "cli/commands/command.hpp"
#include "cli/runs/option_table.hpp"

namespace tcert::cli {

/// What is told to the command, not to the run.
struct Manner {
  bool quiet = false;  ///< No progress and no summary on stderr.
};

/// Reads flags, then the config file for what the flags leave open. False if help was asked for and
/// has been printed: `help` (purpose, usage, example, cost), then the options.
/// \throws UsageError with the nearest known name for an unknown one; NoInput if the config file
/// cannot be read; WriteError if nothing can appear at --output (require_output_place).
[[nodiscard]] bool parse(std::string_view help,
                         const OptionTable& table,
                         Manner& manner,
                         Arguments arguments);

}  // namespace tcert::cli
