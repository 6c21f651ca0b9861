#pragma once
/// \file
/// The commands whose work can be done in pieces.

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "cli/runs/batch/trial_features.hpp"
#include "cli/runs/errors.hpp"
#include "cli/runs/experiment/cells.hpp"
#include "cli/runs/items.hpp"
#include "cli/runs/read_request.hpp"
#include "cli/runs/study/study.hpp"

namespace tcert::cli {

/// A command with its request.
struct Pieces {
  std::function<std::vector<ItemSet>(std::int64_t threads, Progress& progress)> items;
  /// What the command makes of items from there: into the folder `output`, or shown without it.
  std::function<ExitCode(const std::string& output,
                         std::int64_t threads,
                         Progress& progress,
                         const ItemSource& source)>
      finish;
};

/// The command that a plan names. \throws NotReproducible if there is none, or if its words are
/// none of its command's.
[[nodiscard]] Pieces pieces_of(const std::string& command,
                               std::span<const ManifestArgument> words,
                               const FindInput& find);

}  // namespace tcert::cli
