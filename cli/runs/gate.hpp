#pragma once
/// \file
/// `gate`: the bottleneck micro-study.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct GateRequest {
  std::string bundle;
  double level = 0.95;
  std::int64_t replicates = 1999;
  std::string table;
  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(GateRequest& request);

/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode gate(const GateRequest& request, Progress& progress);

}  // namespace tcert::cli
