#pragma once
/// \file
/// What stands below the tables of H2.

#include <string>
#include <vector>

#include "analysis/study/h2/hypothesis_h2.hpp"

namespace tcert {

/// "paper", "landmark"; "table" where there is no other panel.
[[nodiscard]] std::string h2_panel_name(const study::H2Table& h2, const study::H2Panel& panel);

[[nodiscard]] std::vector<std::string> h2_level_notes(const study::H2Table& h2);
[[nodiscard]] std::vector<std::string> h2_equality_notes(const study::H2Table& h2);

}  // namespace tcert
