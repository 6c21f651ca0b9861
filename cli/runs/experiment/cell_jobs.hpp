#pragma once
/// \file
/// Which tables of trials cells need, each distinct one once.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "analysis/study/experiment/cell.hpp"

namespace tcert::cli {

enum class TableKind : std::uint8_t { features, replay };

/// A table to be made.
struct Job {
  TableKind kind = TableKind::features;
  const study::ParameterSet* set = nullptr;
  std::string print;  ///< Fingerprint of the set up to the table.
};

/// Jobs in the order in which neighbours share most steps, and which of them each cell uses.
struct Jobs {
  std::vector<Job> jobs;
  std::vector<std::size_t> features_of;
  std::vector<std::size_t> replays_of;
};

inline constexpr std::size_t kNoTable = static_cast<std::size_t>(-1);

/// Cells that are refused have kNoTable.
[[nodiscard]] Jobs jobs_of(std::span<const study::PlannedCell> cells);

}  // namespace tcert::cli
