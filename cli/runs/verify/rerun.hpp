#pragma once
/// \file
/// The run that a manifest names, as far as a manifest may name one: whoever wrote it may be a
/// stranger.

#include <functional>
#include <string>

#include "cli/runs/progress.hpp"
#include "cli/runs/read_request.hpp"
#include "reports/manifest_read.hpp"

namespace tcert::cli {

/// Makes the result again at `output`. \throws what the run does.
using Rerun = std::function<void(const std::string& output, Progress& progress)>;

/// Only the runs that make results are let through, and of their options only those that shape what
/// is made (OptionRole): none that says where something else is written or kept, or how. Every word
/// that names a file must be an input, by its bare name: is_path_step(). An input that is not found
/// is left out. \throws NotReproducible.
[[nodiscard]] Rerun rerun_of(const WrittenResult& manifest, const FindInput& find);

}  // namespace tcert::cli
