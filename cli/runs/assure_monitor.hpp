#pragma once
/// \file
/// `assure monitor`: rules over logged trials, held against the truth and against injected faults.

#include "cli/runs/errors.hpp"
#include "cli/runs/guard_options.hpp"
#include "cli/runs/inputs.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct AssureMonitorRequest {
  std::string kind;  ///< "monitor".
  std::string bundle;
  std::string rules;  ///< A file of them; empty: the default ones.
  bool risk = false;
  std::string tracking_error;
  double claim = 0.9;
  std::string table;
  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(AssureMonitorRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode assure_monitor(const AssureMonitorRequest& request, Progress& progress);

}  // namespace tcert::cli
