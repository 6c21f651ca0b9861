#pragma once
/// \file
/// A table of options as Boost.Program_options has them.

#include <boost/program_options.hpp>

#include "cli/runs/option_table.hpp"

namespace tcert::cli {

/// Options [begin, end) of the table, under a heading.
[[nodiscard]] boost::program_options::options_description description_of(const std::string& heading,
                                                                         const OptionTable& table,
                                                                         std::size_t begin,
                                                                         std::size_t end);

}  // namespace tcert::cli
