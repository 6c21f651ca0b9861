#pragma once
/// \file
/// Values that mean that nothing is known.

#include <span>
#include <string>
#include <vector>

#include "datasets/terrain_file.hpp"

namespace tcert::terrain_reading {

struct GapsResult {
  std::size_t gaps = 0;            ///< All NaN, those that were before among them.
  std::vector<std::string> notes;  ///< What was taken for gaps, and what perhaps should have been.
  std::string problem;             ///< Fit to follow "expected "; empty if the rest are values.
};

/// Makes NaN of what the rule takes for nodata. `declared` is what the file itself declares; the
/// rule's own goes before it, and neither is used if the rule recognises none. A value beyond
/// +-1e30 that is no gap is a problem, and so is a terrain of gaps alone. O(values).
[[nodiscard]] GapsResult mark_gaps(std::span<double> values,
                                   const NodataRule& rule,
                                   std::optional<double> declared);

}  // namespace tcert::terrain_reading
