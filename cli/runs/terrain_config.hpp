#pragma once
/// \file
/// The configuration file of the exploration, as its authors print it.

#include <optional>
#include <string>
#include <vector>

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
  std::optional<double> frames;              ///< display.FRAMECOUNT
  std::optional<double> start_x;             ///< robot.STARTING_X
  std::optional<double> start_y;             ///< robot.STARTING_Y
  std::optional<double> goal_x;              ///< robot.GOAL_X
  std::optional<double> goal_y;              ///< robot.GOAL_Y
  std::optional<std::string> start;          ///< "X,Y" of the two.
  std::optional<std::string> goal;
  std::vector<std::string> notes;  ///< What has no effect here, a sentence each.
};

/// Sections in brackets, KEY = value, words in double quotes or not, # begins a comment.
/// Both printed versions are read: environment.MODE = "semnav" is a mode that was never written and
/// is left out with a note. Numbers are within the limits of the options that they stand for, those
/// of cells whole; STARTING_X and STARTING_Y, and GOAL_X and GOAL_Y, come together.
/// \throws NoInput if the file cannot be read; UsageError naming file, key and the nearest known
/// key, or the value that is none.
[[nodiscard]] TerrainConfig read_terrain_config(const std::string& path);

}  // namespace tcert::cli
