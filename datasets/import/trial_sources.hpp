#pragma once
/// \file
/// Which trials there are in what the user named, and the files of each.

#include <filesystem>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/csv_streams.hpp"
#include "datasets/import/log_map.hpp"

namespace tcert::recording {

struct TrialSource {
  std::string trial_id;         ///< Empty if a column of the files says it.
  std::filesystem::path bag;    ///< Of streams that are topics.
  StreamFiles files;            ///< Of streams that are files, one a stream of the map.
  std::string problem;          ///< The file that is missing, in words; or empty.
  std::filesystem::path place;  ///< Where it would be.
};

/// Of topics: each source is a bag, or a folder of bags; its name without its end is that of the
/// trial. Of files: with {trial} in the names of the map, every text that fits is a trial of each
/// source, a folder; else each source is one trial: a folder with the files of the map, or, where
/// the map names no files, a file. At most 100,000 files are looked at. Sorted by name. A file may
/// end in .gz or .zst. Errors: two trials of one name, none at all; a file that is missing, if
/// there is one trial alone, else it is the trial's `problem`; of control that is missing, nothing.
[[nodiscard]] std::vector<TrialSource> find_trials(
    const std::vector<std::filesystem::path>& sources,
    const LogMap& map,
    table::DiagnosticGroups& problems);

}  // namespace tcert::recording
