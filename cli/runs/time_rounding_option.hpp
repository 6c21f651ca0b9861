#pragma once
/// \file
/// The option of every command that fits times.

#include "cli/options.hpp"

namespace tcert::cli {

/// --no-time-rounding, into `off`.
void add_time_rounding_option(po::options_description& own, bool& off);

}  // namespace tcert::cli
