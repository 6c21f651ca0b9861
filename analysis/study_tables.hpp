#pragma once
/// \file
/// What a study comes to before any hypothesis: successes per cell, commanded speed and latency,
/// beside what the paper prints for its own 660 trials.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/feature_table.hpp"
#include "analysis/study.hpp"

namespace tcert {

/// One trial of a study, without its ticks.
struct TrialSummary {
  FeatureRow row;
  std::optional<double> median_speed_cmd_mps;  ///< Of its control samples.
  std::optional<double> median_loop_latency_ms;
};

[[nodiscard]] TrialSummary summarise(const StudiedTrial& trial);

/// Successes of one algorithm under one lighting.
struct CellCount {
  std::string algorithm;
  std::string lighting;
  std::size_t trials = 0;  ///< With a known outcome.
  std::size_t successes = 0;
};

/// One entry per pair that occurs, sorted by algorithm, then lighting, in the order of the paper's
/// tables; names that the paper does not have come last, in byte order.
[[nodiscard]] std::vector<CellCount> count_successes(std::span<const TrialSummary> trials);

enum class MedianGroup { algorithm, lighting, cell };

struct GroupMedian {
  std::string algorithm;  ///< Empty if the group is a lighting.
  std::string lighting;   ///< Empty if the group is an algorithm.
  std::size_t trials = 0;
  std::optional<double> speed_cmd_mps;
  std::optional<double> loop_latency_ms;
};

/// Medians over trials of the trials' own medians, so that a slow trial weighs as much as a fast
/// one. Same order as count_successes. O(trials log trials).
[[nodiscard]] std::vector<GroupMedian> group_medians(std::span<const TrialSummary> trials,
                                                     MedianGroup group);

/// A median that the paper prints (section 4.1), for an algorithm or for a lighting.
struct PublishedSpeed {
  std::string_view name;
  double speed_cmd_mps = 0.0;
};

[[nodiscard]] std::span<const PublishedSpeed> published_speeds() noexcept;

inline constexpr double kPublishedLatencyMs = 19.6;  ///< p50 in every cell, within 0.1.

/// Order in which the paper lists algorithms and lightings; names that it does not have come last.
[[nodiscard]] bool paper_order(std::string_view a, std::string_view b) noexcept;

}  // namespace tcert
