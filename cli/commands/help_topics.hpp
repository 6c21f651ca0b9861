#pragma once
/// \file
/// What `help` shows that is no command: tables made from what the code declares.

#include <span>
#include <string_view>

#include "reports/table.hpp"

namespace tcert::cli {

struct HelpTopic {
  std::string_view name;
  std::string_view summary;  ///< One line.
  Table (*table)();
};

/// parameters, columns, bundle, map, rules.
[[nodiscard]] std::span<const HelpTopic> help_topics();

}  // namespace tcert::cli
