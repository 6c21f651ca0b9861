#pragma once
/// \file
/// Whether what was read of a trial is enough to certify it.

#include <filesystem>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/stream_set.hpp"

namespace tcert::recording {

/// What became of one trial.
struct ImportedTrial {
  std::string trial_id;
  bool rejected = false;  ///< And why, among the problems.
  std::optional<bool> success;
  std::vector<StreamResult> streams;  ///< One a stream of the map.
};

/// Of all streams of rays, which are one file: when the first begins and the last ends.
[[nodiscard]] StreamUse use_of_rays(const LogMap& map, const ImportedTrial& trial);

/// `files` has the file of each stream, or one of all. Rejects the trial, with an error, if a
/// stream that is required uses less than 90 % of its rows, if pose and rays have no common time,
/// or if fewer than 10 ticks would come of it. Commands that have no time in common with them are
/// removed from `folder`, with a warning. Readings of ranges of which more than 5 % are none, and
/// not declared, are a warning.
void judge_trial(const LogMap& map,
                 ImportedTrial& trial,
                 const std::filesystem::path& folder,
                 const std::vector<std::filesystem::path>& files,
                 table::DiagnosticGroups& problems);

}  // namespace tcert::recording
