#pragma once
/// \file
/// `explore`: a terrain that is felt one cell at a time.

#include <optional>
#include <string>
#include <vector>

#include "cli/runs/errors.hpp"
#include "cli/runs/progress.hpp"
#include "cli/runs/shared_options.hpp"

namespace tcert::cli {

struct ExploreRequest {
  std::string terrain;
  std::string config;
  std::string rules = "certified";
  std::string start;
  std::string goal;
  std::string mode;
  std::string header = "auto";
  std::string format = "auto";
  std::string nodata = "auto";
  double threshold = 1000.0;
  std::string lipschitz;
  double confidence = 0.95;
  double beta = 3.0;
  std::int64_t expanders = 40;
  double kernel_variance = 2.0;
  double kernel_length_scale = 30.0;
  double kernel_mean = 0.0;
  double noise_variance = 1.0;
  double noise_bound = 0.0;
  double noise_sd = 0.0;
  std::string gradient_prior;                ///< "SD,PLACES".
  std::optional<double> least_length_scale;  ///< None: half of kernel_length_scale.
  std::int64_t start_radius = 2;
  std::string known;
  std::string motion;  ///< Empty: by the rules.
  double sub_goal_depth = 0.0;
  double simplification = 4.0;
  double robot_radius = 2.0;
  std::string body;       ///< "R", "LENGTH,WIDTH" or "LENGTH,WIDTH,YAW_DEG"; empty: a point.
  std::string selection;  ///< Empty: by the rules.
  bool look_ahead = false;
  std::int64_t horizon = 3;
  double growth_weight = 0.5;
  double travel_weight = 0.1;
  bool adaptive = false;
  bool trust_model = false;
  std::string obstacles;
  std::string units = "cells";
  double cell_size = 1.0;
  std::string rasters;
  std::string baseline;
  std::int64_t max_steps = 2000;
  std::int64_t frames = 9;
  OutputPath output;
  std::int64_t seed = 1;
  std::vector<std::string> given;  ///< Those go before the config file.
};

/// All but the terrain and those that commands share.
void add_explore_options(OptionTable& table, ExploreRequest& request);
[[nodiscard]] OptionTable options_of(ExploreRequest& request);

/// The summary as text; with an output also the folder of results. The code says how it ended.
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode explore(const ExploreRequest& request, Progress& progress);

}  // namespace tcert::cli
