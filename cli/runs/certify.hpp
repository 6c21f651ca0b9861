#pragma once
/// \file
/// `certify`: the certificate at every tick of a bundle's trials, and each trial's features.

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct CertifyRequest {
  std::string bundle;
  bool ticks = false;
  bool no_series = false;
  bool ray_margins = false;
  bool witness = false;
  bool witness_edges = false;
  bool submaps = false;
  bool truth = false;
  std::string ground;
  LogOptions logs;
  OutputOptions output;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(CertifyRequest& request);

/// Into the folder of results, or the features as text.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode certify(const CertifyRequest& request, Progress& progress);

}  // namespace tcert::cli
