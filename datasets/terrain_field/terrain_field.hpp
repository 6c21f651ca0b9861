#pragma once
/// \file
/// Random terrains with a stated Lipschitz constant.

#include <cstdint>

#include "datasets/terrain_file.hpp"

namespace tcert {

/// Covariance of the field, of length scale l at distance d.
enum class FieldKind {
  gaussian,  ///< exp(-d^2 / 2 l^2), squared-exponential: smooth.
  matern52,  ///< Matern of smoothness 5/2: twice differentiable.
  matern32,  ///< Matern of smoothness 3/2: once.
};

struct TerrainFieldOptions {
  FieldKind kind = FieldKind::gaussian;
  int rows = 600;
  int columns = 400;
  double mean = 1000.0;
  double length_scale = 70.0;  ///< Cells; of the covariance.
  double lipschitz = 18.0;     ///< Of the finished field, per cell: between any two cells.
  std::uint64_t seed = 1;
  std::uint64_t number = 0;  ///< Of the field among those of the seed.
};

/// mean + c g, g a sum of 256 random waves whose covariance is that of a Gaussian process in the
/// mean over seeds (the waves' numbers are draws of the spectral density: normal, or Student's t
/// with twice the smoothness as degrees of freedom; Rasmussen and Williams 2006, section 4.2), c
/// such that the steepest bilinear gradient is `lipschitz`: then |f(p) - f(q)|
/// <= lipschitz |p - q| for all cells. O(256 cells). \throws std::invalid_argument for a size below
/// 2 x 2 or a scale that is not positive.
[[nodiscard]] TerrainGrid random_terrain(const TerrainFieldOptions& options);

}  // namespace tcert
