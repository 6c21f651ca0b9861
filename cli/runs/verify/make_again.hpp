#pragma once
/// \file
/// A result made again from its inputs, and what is not the same.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/runs/progress.hpp"
#include "cli/runs/verify/targets.hpp"

namespace tcert::cli {

/// What was found of one result.
struct Finding {
  std::vector<std::string> differences;  ///< It does not stand.
  std::vector<std::string> obstacles;    ///< Why it cannot be made again here.
  bool made_again = false;
};

/// Runs what the target's manifest names with the arguments of its manifest, the inputs found by
/// find_input(), into a scratch folder, and compares. Where it cannot be run, or its arguments are
/// none that this tool writes (rerun_of()), the files are compared with the manifest. \throws
/// std::system_error if a file cannot be read.
[[nodiscard]] Finding made_again(const VerifyTarget& target,
                                 const std::filesystem::path& results,
                                 const std::vector<std::string>& inputs,
                                 Progress& progress);

}  // namespace tcert::cli
