#pragma once
/// \file
/// The trials of a tree of results as the blocks of the page.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cli/runs/progress.hpp"
#include "reports/html/page.hpp"
#include "reports/results/results.hpp"

namespace tcert::cli {

struct TrialPageOptions {
  std::string bundle;     ///< Where courses are; empty: the corpus of the tree, if it has one.
  std::size_t ticks = 0;  ///< Most a trial; 0: by the number of trials.
  int threads = 0;        ///< 0: all cores.
};

/// Most ticks of a trial on the page: few enough that the page of a study of 660 trials stays below
/// 10 MB, and one of 10,000 opens in seconds.
[[nodiscard]] std::size_t ticks_shown(std::size_t trials) noexcept;

/// Fills `page.trials`, `series` and `worlds` from the result that holds features.csv or
/// certificates.csv; adds a sentence to `left_out` for everything that is not there. Number of
/// trials. The blocks are the same for any number of threads. \throws BadData if a file cannot be
/// used, or the bundle is not the one that was certified; NoInput.
std::size_t add_trials(const Results& results,
                       const TrialPageOptions& options,
                       Progress& progress,
                       PageData& page,
                       std::vector<std::string>& left_out);

}  // namespace tcert::cli
