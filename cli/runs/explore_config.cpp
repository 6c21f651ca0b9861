#include "cli/runs/explore_config.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <terrain/rules.hpp>

namespace tcert::cli {

void apply_config(ExploreRequest& request, Progress& progress) {
  if (request.config.empty()) {
    return;
  }
  const TerrainConfig file = read_terrain_config(request.config);
  for (const std::string& note : file.notes) {
    progress.say(request.config + ": " + note);
  }
  const auto take = [&](const char* name, auto& into, const auto& from) {
    if (from && !is_given(request.given, name)) {
      // Whole numbers and bounds were checked as they were read.
      into = static_cast<std::decay_t<decltype(into)>>(*from);
    }
  };
  take("threshold", request.threshold, file.threshold);
  take("simplification", request.simplification, file.simplification);
  take("robot-radius", request.robot_radius, file.robot_radius);
  take("expanders", request.expanders, file.expanders);
  take("kernel-variance", request.kernel_variance, file.kernel_variance);
  take("kernel-length-scale", request.kernel_length_scale, file.kernel_lengthscale);
  take("beta", request.beta, file.beta);
  if (file.beta) {
    request.given.emplace_back("beta");
  }
  take("frames", request.frames, file.frames);
  take("start", request.start, file.start);
  if (file.lipschitz && !is_given(request.given, "lipschitz")) {
    request.lipschitz = fmt::format("{}", *file.lipschitz);
  }
  // A goal by flag is to be gone to, and exploring by flag needs none.
  if (!is_given(request.given, "goal")) {
    take("mode", request.mode, file.mode);
    if (request.mode != "explore") {
      take("goal", request.goal, file.goal);
    }
  }
  if (request.terrain.empty() && file.filename) {
    // Beside the config file, as the program that it belongs to reads it.
    request.terrain =
        (std::filesystem::path(request.config).parent_path() / *file.filename).string();
  }
}

void settle_beta(ExploreRequest& request, Progress& progress) {
  const bool is_band = request.rules == "band";
  if (!request.trust_model && !is_band) {
    return;
  }
  if (!is_given(request.given, "beta")) {
    request.beta = terrain::kTrustedBeta;
  } else if (request.beta < terrain::kTrustedBeta) {
    progress.say(
        fmt::format("warning: {} certifies by a band of {:.3g} sd (--beta {:g}); at less "
                    "than {:.3g} sd (--beta {:g}) it holds unsafe cells safe: see --help",
                    is_band ? "--rules band" : "--trust-model",
                    std::sqrt(request.beta),
                    request.beta,
                    std::sqrt(terrain::kTrustedBeta),
                    terrain::kTrustedBeta));
  }
}

}  // namespace tcert::cli
