#pragma once
/// \file
/// The thesis' five scenarios and the rule sets they are run under.

#include <cstdint>
#include <optional>
#include <string>
#include <terrain/explore.hpp>
#include <vector>

namespace tcert::terrain::study {

struct Scenario {
  std::string name;
  std::string figure;
  double threshold = 1000.0;
  Cell start;
  std::optional<Cell> goal;
  int thesis_iterations = 0;  ///< As printed.
  bool reuse = false;         ///< Begins with the map of a run of "around".
  int max_steps = 2000;
};

/// 4.2 to 4.6, with the starts and goals that are known and stated stand-ins for the others.
[[nodiscard]] std::vector<Scenario> scenarios();

/// One way to run a scenario.
struct Variant {
  std::string name;
  Rules rules;
  GpPrior prior;
  bool batch = true;  ///< 50 draws round the start are measured first, as published.
  Motion motion = Motion::route;
  AdaptivePrior adaptive;
  double sub_goal_depth = 0.0;
  double confidence =
      0.0;  ///< Above 0: the 13 cells round the start are measured first, and bound.
};

/// Prior whose steepest expected gradient is `lipschitz`: the scale of the data, from the constant.
[[nodiscard]] GpPrior prior_of(double lipschitz, double length_scale, double mean);

[[nodiscard]] Variant published(double threshold);
[[nodiscard]] Variant thesis_as_printed(double threshold);
[[nodiscard]] Variant thesis_tuned(double threshold, double lipschitz);
[[nodiscard]] Variant certified(double threshold, double lipschitz, double mean);

/// The start's 50 draws of the published program; those below the threshold are discarded, and
/// those that are blocked, if `blocked` is not empty.
[[nodiscard]] std::vector<Cell> first_batch(const Terrain& terrain,
                                            const CellSet& blocked,
                                            Cell start,
                                            double threshold,
                                            std::uint64_t seed);

/// Settles by what is measured first, `setup.known` among it, if the variant bounds anything.
void settle_by_start(ExploreSetup& setup, const Terrain& terrain);

[[nodiscard]] ExploreSetup setup_of(const Terrain& terrain,
                                    const Scenario& scenario,
                                    const Variant& variant,
                                    std::uint64_t seed);

}  // namespace tcert::terrain::study
