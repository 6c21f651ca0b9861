#pragma once
/// \file
/// Trials under several parameter sets at once: each log is read once, and each step of the way is
/// done once for all sets that agree so far.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "analysis/study/trials/parameters.hpp"
#include "analysis/study/trials/study.hpp"
#include "datasets/bundle.hpp"

namespace tcert::study {

/// Called for a trial under one set while its ticks and series are at hand, from any thread; what
/// it returns is kept. `trial` may be changed in what the next set does not use: not its ticks and
/// series.
using TrialText = std::function<std::string(StudiedTrial& trial, std::size_t set)>;

/// What came of one trial.
struct CellTrial {
  const TrialRow* row = nullptr;
  std::vector<table::Diagnostic> diagnostics;
  bool rejected = false;           ///< The log cannot be used, whatever the parameters.
  std::vector<std::string> texts;  ///< One per set; empty if rejected.
};

/// How often a step was done, and how often its result was used again by the next set.
struct ReuseCount {
  std::size_t done = 0;
  std::size_t reused = 0;
};

struct CellReuse {
  ReuseCount read, resample, certify, features;
};

/// Steps are shared by neighbours: sort the sets by `fingerprint` of the later stages to share
/// most. Calls `take` in the order of `trials`, one at a time; the same calls for any number of
/// threads. \throws std::invalid_argument if a set is out of range; whatever the callbacks throw.
CellReuse study_cells(const Bundle& bundle,
                      std::span<const std::size_t> trials,
                      std::span<const ParameterSet> sets,
                      const StudyOptions& options,
                      const TrialText& text,
                      const std::function<void(CellTrial&&)>& take);

}  // namespace tcert::study
