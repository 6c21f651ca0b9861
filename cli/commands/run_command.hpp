#pragma once
/// \file
/// From the words of a command line to an exit code.

#include <string>
#include <utility>

#include "cli/commands/command_line.hpp"
#include "cli/commands/terminal_progress.hpp"
#include "cli/runs/errors.hpp"

namespace tcert::cli {

/// What the request takes, as its command shows it.
template <class Request>
[[nodiscard]] CommandForm form_for(std::string_view help, std::string word = {}) {
  Request request;
  return form_of(help, options_of(request), std::move(word));
}

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
