#pragma once
/// \file
/// `drive`: policies in closed loop, as a bundle with its manifest.

#include <filesystem>

#include "analysis/study/driven/drive_case.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/items.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct DriveRequest {
  std::string policies;   ///< Arms, comma between; empty: the six policies.
  std::string lightings;  ///< Comma between; empty: all.
  std::optional<std::int64_t> worlds;
  std::int64_t trials = 660;
  std::int64_t from = 0;
  bool native_rates = false;
  bool truth = false;          ///< Also write truth.csv.
  bool stdio = false;          ///< One trial, whose policy is another process.
  std::string listen;          ///< The same over a Unix socket.
  std::string name = "stdio";  ///< Of that policy.
  std::string rules;  ///< A file, of rules that arms with +monitor watch; empty: the default ones.
  ParameterChanges parameters;
  OutputPath output;
  std::int64_t seed = 1;
  std::int64_t threads = 0;
  std::vector<std::string> given;
};

[[nodiscard]] OptionTable options_of(DriveRequest& request);

/// Writes the bundle and its manifest.json whole or not at all. \throws UsageError, WriteError.
[[nodiscard]] ExitCode drive(const DriveRequest& request, Progress& progress);

/// How many trials are asked for, and a bundle of some of them in a new folder. \throws UsageError.
[[nodiscard]] std::uint64_t trials_of(const DriveRequest& request);
void make_trials(const DriveRequest& request,
                 ItemRange trials,
                 const std::filesystem::path& folder);

/// True if the output is this bundle as this build makes it, every file with its bytes.
[[nodiscard]] bool is_there(const DriveRequest& request);

}  // namespace tcert::cli
