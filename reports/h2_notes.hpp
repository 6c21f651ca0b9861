#pragma once
/// \file
/// What stands below the tables of H2.

#include <string>
#include <vector>

#include "analysis/study/h2/hypothesis_h2.hpp"

namespace tcert {

[[nodiscard]] std::vector<std::string> h2_level_notes(const study::H2Table& h2);
[[nodiscard]] std::vector<std::string> h2_equality_notes(const study::H2Table& h2);

}  // namespace tcert
