#pragma once
/// \file
/// What a run gives back.

#include <string>

#include "cli/runs/errors.hpp"

namespace tcert::cli {

struct RunResult {
  ExitCode code = exit_done;
  std::string text;  ///< To be printed; empty if all went to the output, or was shown already.
};

}  // namespace tcert::cli
