#pragma once
/// \file
/// H3 at one beta a law, for all laws and lightings at one time.

#include <string>

#include "analysis/study/h3/hypothesis_h3.hpp"
#include "reports/table.hpp"

namespace tcert {

/// "10", or of several folds "10 (3 of 5 folds), 20 (2)".
[[nodiscard]] std::string h3_betas(const study::H3Chosen& one);

/// Table h3_chosen: a row a law and lighting.
[[nodiscard]] Table h3_chosen_table(const study::H3Table& h3);

}  // namespace tcert
