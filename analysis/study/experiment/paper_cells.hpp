#pragma once
/// \file
/// The cells that the paper asks for, and those that its silence asks for.

#include <vector>

#include "analysis/study/experiment/cell.hpp"

namespace tcert::study {

/// Paper 3.3: A1 no contact memory, A2 unknown space taken for free, A3 no curvature; then their
/// pairs and all three.
[[nodiscard]] std::vector<Cell> ablation_cells();

/// A4, of data that have slope, step or slip: the plane alone.
[[nodiscard]] Cell footing_ablation();

/// One parameter at a time: every choice that the paper leaves open (lib/README.md says how it was
/// settled), at other values that one could defend. What they do to H1 is its specification curve.
[[nodiscard]] std::vector<Cell> sensitivity_cells();

}  // namespace tcert::study
