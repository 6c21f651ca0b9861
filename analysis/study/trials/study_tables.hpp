#pragma once
/// \file
/// What a study comes to before any hypothesis: successes per cell, commanded speed and latency,
/// beside what the paper prints for its own 660 trials.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/study/trials/feature_table.hpp"
#include "analysis/study/trials/study.hpp"
#include "analysis/study/trials/tally.hpp"

namespace tcert::study {

/// One trial of a study, without its ticks.
struct TrialRecord {
  FeatureRow row;
  std::optional<double> median_speed_cmd_mps;  ///< Of its control samples.
  std::optional<double> median_loop_latency_ms;
  Tally speed_cmd_mps;  ///< Of its known samples.
  Tally loop_latency_ms;
};

[[nodiscard]] TrialRecord summarise(const StudiedTrial& trial);

/// Trials of one algorithm under one lighting; of all where a name is empty.
struct StudyGroup {
  std::string algorithm;
  std::string lighting;
  std::size_t trials = 0;
  std::size_t known = 0;  ///< With a known outcome.
  std::size_t successes = 0;
  Tally speed_cmd_mps;  ///< All control samples pooled: a slow trial has more of them.
  Tally loop_latency_ms;
};

/// Everything that the tables of a study need; trials are added one at a time.
class StudyRecord {
 public:
  void add(TrialRecord&& trial);

  [[nodiscard]] const std::vector<FeatureRow>& rows() const noexcept { return rows_; }

  /// Groups that occur, in the order of the paper's tables; names that it does not have come last,
  /// in byte order.
  [[nodiscard]] std::vector<StudyGroup> by_cell() const;
  [[nodiscard]] std::vector<StudyGroup> by_algorithm() const;
  [[nodiscard]] std::vector<StudyGroup> by_lighting() const;

  /// All trials as one group; both names are empty.
  [[nodiscard]] StudyGroup all() const;

  /// True if there is a trial and every algorithm is one of the paper's: what it prints may stand
  /// beside the data.
  [[nodiscard]] bool is_of_paper() const;

 private:
  using Key = std::pair<std::string, std::string>;  // algorithm, lighting
  struct PaperOrder {
    bool operator()(const Key& a, const Key& b) const noexcept;
  };
  using Groups = std::map<Key, StudyGroup, PaperOrder>;

  [[nodiscard]] std::vector<StudyGroup> merged(bool by_algorithm) const;

  std::vector<FeatureRow> rows_;
  Groups cells_;
};

/// True for the six algorithms of the paper's trials.
[[nodiscard]] bool is_paper_algorithm(std::string_view name) noexcept;

/// A median that the paper prints (section 4.1), for an algorithm or for a lighting; "0.17-0.18"
/// and "0.13-0.14" by their middles. Empty for any other name.
[[nodiscard]] std::optional<double> published_speed_mps(std::string_view name) noexcept;

inline constexpr double kPublishedLatencyMs = 19.6;  ///< p50 in every cell, within 0.1.

}  // namespace tcert::study
