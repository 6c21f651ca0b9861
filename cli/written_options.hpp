#pragma once
/// \file
/// What a manifest says of the options of a command.

#include <vector>

#include "cli/options.hpp"
#include "reports/manifest.hpp"

namespace tcert::cli {

/// Every option of `shown` that shapes the result, with its value, and inputs by their names.
[[nodiscard]] Settings written_options(const po::variables_map& values,
                                       const po::options_description& shown);

/// The command line that would give the same result, whether it was given by flags or by a file.
[[nodiscard]] std::vector<ManifestArgument> written_arguments(const CommandLine& line,
                                                              const po::variables_map& values,
                                                              const po::options_description& shown,
                                                              const CommonOptions& common);

}  // namespace tcert::cli
