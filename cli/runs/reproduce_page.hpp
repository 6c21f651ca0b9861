#pragma once
/// \file
/// What `reproduce` says at its end, on the terminal and as a page. Internal to it.

#include <string>

#include "cli/runs/progress.hpp"
#include "cli/runs/reproduce.hpp"

namespace tcert::cli {

/// What was found of the dealt trials or of the logs, then of the driven ones; the tables are in
/// their files.
[[nodiscard]] std::string pages_of(const ReproduceRequest& request, const Progress& progress);

/// The page of all results, if this build has one: its path is said last.
void write_page(const ReproduceRequest& request, Progress& progress);

}  // namespace tcert::cli
