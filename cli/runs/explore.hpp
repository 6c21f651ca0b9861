#pragma once
/// \file
/// What `explore` is asked: flags and the config file.

#include <cstdint>
#include <string>

#include "cli/options.hpp"
#include "cli/terrain_config.hpp"

namespace tcert::cli {

struct ExploreOptions {
  std::string terrain;
  std::string config;
  std::string rules = "certified";
  std::string start;
  std::string goal;
  std::string mode;
  std::string header = "auto";
  std::string format = "auto";
  std::string nodata = "auto";
  std::string motion = "route";
  std::string lipschitz;
  std::string obstacles;
  double threshold = 1000.0;
  double beta = 3.0;
  std::int64_t expanders = 40;
  double kernel_variance = 2.0;
  double kernel_length_scale = 30.0;
  double kernel_mean = 0.0;
  double noise_variance = 1.0;
  double noise_bound = 0.0;
  double confidence = 0.95;
  double simplification = 4.0;
  double robot_radius = 2.0;
  double travel_weight = 0.1;
  std::int64_t start_radius = 2;
  std::int64_t max_steps = 2000;
  std::int64_t frames = 9;
  bool look_ahead = false;
  bool adaptive = false;
  bool trust_model = false;
  bool beta_is_told = false;  ///< By flag or file.
};

[[nodiscard]] CommandLine explore_command_line(ExploreOptions& options);

/// Fills what the flags left open from the config file, and says what of it has no effect.
/// \throws NoInput, UsageError.
void apply_config(ExploreOptions& options, const CommonOptions& common);

/// With --trust-model: the band that it needs unless one was told, and a warning if it is narrower.
void settle_beta(ExploreOptions& options, const CommonOptions& common);

}  // namespace tcert::cli
