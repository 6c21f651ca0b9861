#pragma once
/// \file
/// What the commands that guard a run have in common: the tracking-error table.

#include <optional>
#include <string>
#include <tcert/guards.hpp>

#include "analysis/study/trials/parameters.hpp"
#include "cli/runs/option_table.hpp"
#include "cli/runs/progress.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// Adds --tracking-error.
void add_tracking_error_option(OptionTable& table, std::string& path);

/// The table of the file, or the declared one if `path` is empty. \throws NoInput, BadData.
[[nodiscard]] TrackingErrorTable tracking_error_table(const std::string& path,
                                                      bool decimal_comma,
                                                      Progress& progress);

/// The file as an input of the manifest; empty without one.
[[nodiscard]] std::optional<ManifestFile> tracking_error_input(const std::string& path);

}  // namespace tcert::cli
