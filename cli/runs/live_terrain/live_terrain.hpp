#pragma once
/// \file
/// `live terrain`: a robot's own loop over ground that it feels.

#include "cli/runs/explore.hpp"

namespace tcert::cli {

struct LiveTerrainRequest {
  ExploreRequest explore;  ///< Its options that concern a terrain that is not known.
  std::int64_t rows = 0;
  std::int64_t columns = 0;
  std::string listen;
  std::string record;
};

[[nodiscard]] OptionTable options_of(LiveTerrainRequest& request);

/// Measurements from stdin or a socket, a row for each place where the robot stood, at once, to
/// stdout and the socket. The code says how it ended, as that of explore().
/// \throws UsageError, NoInput, BadData, WriteError.
[[nodiscard]] ExitCode live_terrain(const LiveTerrainRequest& request, Progress& progress);

}  // namespace tcert::cli
