#pragma once
/// \file
/// What `explore` is asked: flags, the config file, and the setup that follows from them.

#include <cstdint>
#include <string>
#include <terrain/explore.hpp>

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
  std::string header = "detect";
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
};

[[nodiscard]] CommandLine explore_command_line(ExploreOptions& options);

/// Fills what the flags left open from the config file. \throws NoInput, UsageError.
void apply_config(ExploreOptions& options, const CommonOptions& common);

/// \throws UsageError for words, cells and values that cannot be.
void check(const ExploreOptions& options);

/// "X,Y". \throws UsageError naming the option.
[[nodiscard]] terrain::Cell cell_of(const std::string& option, const std::string& text);

/// The setup for a terrain; says on stderr what of the file could not be used, and why.
/// \throws UsageError; BadData if the start is not on safe ground.
[[nodiscard]] terrain::ExploreSetup explore_setup(const ExploreOptions& options,
                                                  const CommonOptions& common,
                                                  const terrain::Terrain& terrain);

}  // namespace tcert::cli
