#pragma once
/// \file
/// The part of `reproduce` that drives. Internal to it.

#include <filesystem>
#include <utility>
#include <vector>

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/reproduce.hpp"

namespace tcert::cli {

/// True if policies are to be driven: without logs of somebody's own.
[[nodiscard]] bool drives(const ReproduceRequest& request);

/// The folders that driving makes in a study's, with the command that writes each.
[[nodiscard]] std::vector<std::pair<std::filesystem::path, const char*>> driven_parts(
    const std::filesystem::path& output);

/// H1, H2 and H3 of trials that were driven, not dealt: their outcomes come out of gates that know
/// neither policy nor outcome. A tree of results of its own, with its page, in the folder `driven`.
/// \throws as `reproduce`.
[[nodiscard]] ExitCode driven_study(ReproduceRequest request, Progress& progress);

}  // namespace tcert::cli
