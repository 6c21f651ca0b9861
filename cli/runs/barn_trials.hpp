#pragma once
/// \file
/// The files that an import of BARN outcomes is given, each read as what it is.

#include <string>
#include <vector>

#include "cli/runs/progress.hpp"
#include "datasets/import/barn_table.hpp"

namespace tcert::cli {

struct BarnTrials {
  std::vector<BarnTable> tables;
  bool has_errors = false;  ///< Lines of result text that are left out.
};

/// A table with a header that names `world`; its problems are said. \throws UsageError without a
/// name, NoInput without a file, BadData if it is no such table.
[[nodiscard]] BarnTable read_barn_table(const std::string& option,
                                        const std::string& file,
                                        Progress& progress);

/// Tables, and result text whose planner is `planner` or, if that is empty, what the file's name
/// says. \throws as read_barn_table(); UsageError if no planner is named, or one is and there is no
/// result text.
[[nodiscard]] BarnTrials read_barn_trials(const std::vector<std::string>& files,
                                          const std::string& planner,
                                          Progress& progress);

}  // namespace tcert::cli
