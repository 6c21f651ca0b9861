#pragma once
/// \file
/// A CARMEN log made into a bundle of one trial.

#include <filesystem>
#include <optional>
#include <table/atomic_file.hpp>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/import/carmen_bundle.hpp"

namespace tcert {

struct CarmenImportResult {
  std::optional<CarmenSummary> summary;  ///< Empty iff nothing was written.
  std::vector<table::Diagnostic> diagnostics;
};

/// Reads `log` (plain, .gz or .zst) and writes the bundle folder `output`: bundle.json, trials.csv
/// with one row whose success is missing, and logs/<trial_id>/ticks.csv with one tick per scan.
/// Poses that are the odometry are a warning. \throws WriteError if the folder cannot be written;
/// std::invalid_argument on options out of range.
[[nodiscard]] CarmenImportResult import_carmen(const std::filesystem::path& log,
                                               const std::filesystem::path& output,
                                               const CarmenImportOptions& options = {});

}  // namespace tcert
