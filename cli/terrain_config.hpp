#pragma once
/// \file
/// The configuration file of the exploration, as its authors print it.

#include <optional>
#include <string>

namespace tcert::cli {

/// What the file says; what it leaves out is empty.
struct TerrainConfig {
  std::optional<std::string> filename;       ///< environment.FILENAME
  std::optional<double> threshold;           ///< environment.THRESHOLD
  std::optional<double> simplification;      ///< environment.SIMPLIFICATION_CONSTANT
  std::optional<double> robot_radius;        ///< robot.ROBOT_RADIUS
  std::optional<std::string> mode;           ///< robot.MODE or environment.MODE
  std::optional<double> expanders;           ///< optimization.NUM_EXPANDERS
  std::optional<double> kernel_variance;     ///< optimization.KERNEL_VARIANCE
  std::optional<double> kernel_lengthscale;  ///< optimization.KERNEL_LENGTHSCALE
  std::optional<double> beta;                ///< optimization.BETA
  std::optional<double> lipschitz;           ///< optimization.LIPSCHITZ
  std::optional<double> buffer_size;         ///< display.BUFFER_SIZE; read, of no effect.
};

/// Sections in brackets, KEY = value, words in double quotes or not, # begins a comment.
/// \throws NoInput if the file cannot be read; UsageError naming file, key and the nearest known
/// key, or the value that is none.
[[nodiscard]] TerrainConfig read_terrain_config(const std::string& path);

}  // namespace tcert::cli
