#pragma once
/// \file
/// `reproduce`: from logs to every table of the paper.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ReproduceRequest {
  std::string bundle;  ///< Empty: the synthetic corpus, made in the output.
  double effect = 1.0;
  bool no_series = false;
  bool sensitivity = false;
  bool no_driven = false;
  OutputOptions output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  LogOptions logs;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(ReproduceRequest& request);

/// The tables that people read, as text; all results in the output.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode reproduce(const ReproduceRequest& request, Progress& progress);

}  // namespace tcert::cli
