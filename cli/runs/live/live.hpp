#pragma once
/// \file
/// `live`: ticks certified as they arrive.

#include "cli/runs/errors.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct LiveRequest {
  std::string bundle;
  std::string input_format = "auto";
  bool ray_margins = false;
  bool guards = false;
  std::string audit;
  std::string listen;
  std::string record;
  double stale_after_s = 1.0;
  std::string slow_consumer = "auto";
  std::string tracking_error;
  MonitorOptions monitor;
  LogOptions logs;  ///< Of which only parameters and the decimal comma count.
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(LiveRequest& request);

/// Reads stdin or a socket, writes rows to stdout and its status to stderr, and never waits for
/// whoever reads the latter. \throws UsageError, NoInput, BadData, WriteError, std::system_error.
[[nodiscard]] ExitCode live(const LiveRequest& request, Progress& progress);

}  // namespace tcert::cli
