#pragma once
/// \file
/// `figures`: the figures of results for a paper.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct FiguresRequest {
  std::string results;
  std::string trials;
  OutputPath output;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(FiguresRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode figures(const FiguresRequest& request, Progress& progress);

}  // namespace tcert::cli
