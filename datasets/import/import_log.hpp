#pragma once
/// \file
/// A foreign log, in whatever format, made into a bundle by a map.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/import/judge_trial.hpp"

namespace tcert::recording {

struct LogImportOptions {
  bool decimal_comma = false;
};

struct LogImportResult {
  bool is_written = false;           ///< False: there is no bundle, and the problems say why.
  std::vector<std::string> streams;  ///< Keys of the map: "pose", "rays", "control".
  std::vector<ImportedTrial> trials;
  std::size_t rays = 0;
  bool has_goal = false;
  std::vector<table::Diagnostic> diagnostics;
};

/// Told after each trial how many are done.
using TrialsDone = std::function<void(std::size_t done, std::size_t all)>;

/// Reads the sources by the map in the file `map` and writes the bundle `output`: bundle.json with
/// the keys of the map and where it comes from, trials.csv, logs/, and map.json, the map.
///
/// A trial is rejected if a stream that is required uses less than 90 % of its rows, if pose and
/// rays have no common time, or if fewer than 10 ticks would come of it. Commands of another clock
/// are left out. Without any trial nothing is written. \throws table::WriteError.
[[nodiscard]] LogImportResult import_log(const std::vector<std::filesystem::path>& sources,
                                         const std::filesystem::path& map,
                                         const std::filesystem::path& output,
                                         const LogImportOptions& options = {},
                                         const TrialsDone& done = {});

}  // namespace tcert::recording
