#pragma once
/// \file
/// replay.csv: every trial at every speed law, one row each; what H3 is computed from.

#include <string>
#include <vector>

#include "analysis/study/replay/replay_record.hpp"
#include "reports/table.hpp"

namespace tcert {

/// Columns of the table, no rows.
[[nodiscard]] Table replay_table();
[[nodiscard]] std::vector<TableCell> replay_row(const study::ReplayRecord& record);

/// What the replays come to, added up: one row a law and beta; for people.
class ReplayTotals {
 public:
  void add(const study::ReplayRecord& record);
  [[nodiscard]] Table table() const;
  /// The same in sentences, a law and beta each.
  [[nodiscard]] Table findings() const;

 private:
  struct Total {
    SpeedLaw law;
    std::size_t trials = 0;
    std::size_t successes = 0;
    std::size_t kept = 0;
    study::Replay sum;  ///< Lengths, times, stalls and trips.
    study::ReplanSummary replans;
    bool replanned = false;
  };
  std::vector<Total> totals_;
};

}  // namespace tcert
