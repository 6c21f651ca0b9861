#pragma once
/// \file
/// Which row of a panel a gain is over.

#include <cstddef>
#include <optional>

#include "analysis/study/h1/hypothesis_h1.hpp"

namespace tcert::study {

/// The row that gains, and the row that its gain is measured from.
struct Comparison {
  std::size_t better = 0;
  std::size_t than = 0;
};

/// Empty of the predictor under test itself.
[[nodiscard]] std::optional<Comparison> comparison_of(const H1Panel& panel, std::size_t row);

}  // namespace tcert::study
