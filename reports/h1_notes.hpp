#pragma once
/// \file
/// What stands below the tables of H1: who is in a panel, how each number is made.

#include <string>
#include <vector>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert {

[[nodiscard]] std::vector<std::string> h1_success_notes(const study::H1Table& h1);
[[nodiscard]] std::vector<std::string> h1_time_notes(const study::H1Table& h1);

/// Who is in a panel and who is not; `only` if the table has no other panel.
[[nodiscard]] std::string h1_panel_note(const study::H1Options& options,
                                        const study::H1Panel& panel,
                                        bool only);

}  // namespace tcert
