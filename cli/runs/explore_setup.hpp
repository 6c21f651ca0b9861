#pragma once
/// \file
/// What `explore` runs, from what it was asked.

#include <terrain/session.hpp>
#include <vector>

#include "cli/runs/explore.hpp"

namespace tcert::cli {

/// Start, and the goals in turn, if there are any. \throws UsageError if they lie outside the
/// terrain.
struct Places {
  terrain::Cell start;
  std::vector<terrain::Cell> goals;
};
[[nodiscard]] Places places_of(const ExploreRequest& options, const terrain::Grid& grid);

/// Start, goals and obstacles alone.
[[nodiscard]] terrain::ExploreSetup places_setup(const ExploreRequest& options,
                                                 const Places& places,
                                                 terrain::CellSet blocked);

/// What the first measurements need not decide.
[[nodiscard]] terrain::Told told_of(const ExploreRequest& options);

/// The setup as far as the options decide it: see terrain::settle(). \throws UsageError, BadData.
[[nodiscard]] terrain::ExploreSetup unsettled_setup(const ExploreRequest& options,
                                                    const terrain::Grid& grid,
                                                    terrain::CellSet blocked);

/// What terrain::settle() made of the first measurements, on stderr; of `band` the field's
/// variance bound. \pre certified or band
void say_settled(const terrain::ExploreSetup& setup,
                 const ExploreRequest& options,
                 double variance,
                 Progress& progress);

/// The setup for a terrain; says on stderr what of the options could not be used, and why.
/// `blocked` cells are not measured. \throws UsageError; BadData if the start is not on safe
/// ground.
[[nodiscard]] terrain::ExploreSetup explore_setup(const ExploreRequest& options,
                                                  Progress& progress,
                                                  const terrain::Terrain& terrain,
                                                  terrain::CellSet blocked);

}  // namespace tcert::cli
