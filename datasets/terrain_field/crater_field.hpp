#pragma once
/// \file
/// Ground full of craters, made by a stated law: a stand-in for a digital elevation model.

#include <cstdint>

#include "datasets/terrain_file.hpp"

namespace tcert {

/// Cells are a metre wide.
struct CraterFieldOptions {
  int rows = 300;
  int columns = 200;
  double least_diameter = 12.0;
  double most_diameter = 80.0;
  /// Craters larger than D on an area A: density A / D^2. A tenth of geometric saturation, 1.54, as
  /// on surfaces in equilibrium (Gault 1970).
  double density = 0.15;
  int reach = 3;  ///< Cells each way that a slope is taken over: a robot of seven cells.
  double slope_limit = 25.0;  ///< Degrees.
  std::uint64_t seed = 1;
  std::uint64_t number = 0;
};

/// The slope limit less the slope, in degrees: safe is what is at least 0.
///
/// Craters lie anywhere, their diameters D by a power law of exponent -2, as of a surface in
/// equilibrium; each is a bowl of revolution, z = -d + (d + h) (r / R)^2 within its rim and h (R /
/// r)^3 outside, with depth d = D / 5 and rim h = D / 25 when it is fresh (Pike 1977) and a share
/// of that, evenly drawn from 0.1 to 1, as it wears down. Heights add up,
/// and the slope is that of the plane that fits those of `reach` cells each way best: what a robot
/// of so many stands on. O(cells x (craters + reach^2)). \throws std::invalid_argument for a size
/// below 3 x 3 or a law that is none.
[[nodiscard]] TerrainGrid crater_slopes(const CraterFieldOptions& options);

}  // namespace tcert
