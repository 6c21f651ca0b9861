#pragma once
/// \file
/// `replay`: logged trials driven again at gated speed.

#include "cli/runs/errors.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/replay_options.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ReplayRequest {
  std::string bundle;
  ReplayLawOptions laws;
  MonitorOptions monitor;
  bool replan = false;
  bool series = false;
  OutputOptions output;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(ReplayRequest& request);

/// Into the folder of results, or the totals as text.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode replay(const ReplayRequest& request, Progress& progress);

}  // namespace tcert::cli
