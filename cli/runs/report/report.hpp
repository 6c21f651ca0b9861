#pragma once
/// \file
/// `report`: one page of a tree of results.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ReportRequest {
  std::string results;
  std::string bundle;
  std::string title = "Traversability certificates";
  std::int64_t ticks = 0;
  std::string figures;
  OutputPath output;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(ReportRequest& request);

/// \throws UsageError, NoInput (also if this build has no page), BadData, WriteError.
[[nodiscard]] ExitCode report(const ReportRequest& request, Progress& progress);

}  // namespace tcert::cli
