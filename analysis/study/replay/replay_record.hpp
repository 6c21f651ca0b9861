#pragma once
/// \file
/// One trial replayed at one speed law: a row of replay.csv.

#include <optional>
#include <string_view>
#include <tcert/speed_law.hpp>
#include <vector>

#include "analysis/study/replay/replan.hpp"
#include "analysis/study/replay/replay.hpp"
#include "datasets/bundle.hpp"

namespace tcert::study {

/// "squash", "clip", "barrier", "profile".
[[nodiscard]] std::string_view to_string(SpeedLawKind kind) noexcept;

struct ReplayRecord {
  TrialRow trial;
  std::optional<double> loop_latency_ms;  ///< Median, as logged: a replay does not change it.
  SpeedLaw law;
  Replay replay;
  bool kept = false;                     ///< A success that the replay keeps.
  std::optional<ReplanSummary> replans;  ///< If they were asked for.
};

/// The grid of the paper and more: every law at every beta, the other members as in `law`.
[[nodiscard]] std::vector<SpeedLaw> law_grid(const SpeedLaw& law,
                                             const std::vector<SpeedLawKind>& kinds,
                                             const std::vector<double>& betas);

}  // namespace tcert::study
