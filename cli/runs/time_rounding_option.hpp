#pragma once
/// \file
/// The option of every command that fits times.

#include "cli/runs/option_table.hpp"

namespace tcert::cli {

/// --no-time-rounding, into `off`.
void add_time_rounding_option(OptionTable& table, bool& off);

}  // namespace tcert::cli
