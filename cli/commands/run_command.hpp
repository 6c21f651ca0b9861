#pragma once
/// \file
/// From the words of a command line to an exit code.

#include "cli/commands/command_line.hpp"
#include "cli/commands/terminal_progress.hpp"
#include "cli/runs/errors.hpp"

namespace tcert::cli {

/// \throws the errors of errors.hpp.
template <class Request>
int run_command(std::string_view help,
                Arguments arguments,
                ExitCode (*run)(const Request&, Progress&)) {
  Request request;
  Manner manner;
  if (!parse(help, options_of(request), manner, arguments)) {
    return exit_done;
  }
  TerminalProgress progress(manner.quiet);
  return run(request, progress);
}

}  // namespace tcert::cli
