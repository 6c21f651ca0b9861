#include "cli/runs/explore_config.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <terrain/rules.hpp>

namespace tcert::cli {

void apply_config(ExploreRequest& o, Progress& progress) {
  if (o.config.empty()) {
    return;
  }
  const TerrainConfig file = read_terrain_config(o.config);
  for (const std::string& note : file.notes) {
    progress.say(o.config + ": " + note);
  }
  const auto take = [&](const char* name, auto& into, const auto& from) {
    if (from && !is_given(o.given, name)) {
      // Whole numbers and bounds were checked as they were read.
      into = static_cast<std::decay_t<decltype(into)>>(*from);
    }
  };
  take("threshold", o.threshold, file.threshold);
  take("simplification", o.simplification, file.simplification);
  take("robot-radius", o.robot_radius, file.robot_radius);
  take("expanders", o.expanders, file.expanders);
  take("kernel-variance", o.kernel_variance, file.kernel_variance);
  take("kernel-length-scale", o.kernel_length_scale, file.kernel_lengthscale);
  take("beta", o.beta, file.beta);
  if (file.beta) {
    o.given.emplace_back("beta");
  }
  take("frames", o.frames, file.frames);
  take("start", o.start, file.start);
  if (file.lipschitz && !is_given(o.given, "lipschitz")) {
    o.lipschitz = fmt::format("{}", *file.lipschitz);
  }
  // A goal by flag is to be gone to, and exploring by flag needs none.
  if (!is_given(o.given, "goal")) {
    take("mode", o.mode, file.mode);
    if (o.mode != "explore") {
      take("goal", o.goal, file.goal);
    }
  }
  if (o.terrain.empty() && file.filename) {
    // Beside the config file, as the program that it belongs to reads it.
    o.terrain = (std::filesystem::path(o.config).parent_path() / *file.filename).string();
  }
}

void settle_beta(ExploreRequest& o, Progress& progress) {
  if (!o.trust_model) {
    return;
  }
  if (!is_given(o.given, "beta")) {
    o.beta = terrain::kTrustedBeta;
  } else if (o.beta < terrain::kTrustedBeta) {
    progress.say(fmt::format(
        "warning: --trust-model certifies by a band of {:.3g} sd (--beta {:g}); at less "
        "than {:.3g} sd (--beta {:g}) it holds unsafe cells safe: see --help",
        std::sqrt(o.beta),
        o.beta,
        std::sqrt(terrain::kTrustedBeta),
        terrain::kTrustedBeta));
  }
}

}  // namespace tcert::cli
