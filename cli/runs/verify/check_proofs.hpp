#pragma once
/// \file
/// The witnesses of a result, checked against the log without the search that found them.

#include <filesystem>
#include <string>
#include <vector>

#include "cli/runs/verify/make_again.hpp"
#include "cli/runs/verify/targets.hpp"

namespace tcert::cli {

/// Adds to `finding` what does not hold of the files in the target's witness/: the log is read
/// again, F_t is built from it, and the checker measures the paths, that of the trial and those of
/// its edges. Each must state the rays and the course of the bundle, the F_t that is built, the
/// corridor graph of the ticks, and the margins that are measured. A target of another command, or
/// without witnesses, has nothing to check; a bundle that is not found is an obstacle.
void check_proofs(const VerifyTarget& target,
                  const std::filesystem::path& results,
                  const std::vector<std::string>& inputs,
                  Finding& finding);

}  // namespace tcert::cli
