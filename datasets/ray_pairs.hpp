#pragma once
/// \file
/// Bends of a robot's rays beside clearances that were measured otherwise: what a calibration is
/// fitted to.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <table/bytes.hpp>
#include <table/csv.hpp>
#include <table/diagnostic.hpp>
#include <vector>

namespace tcert {

/// One tick of one ray.
struct RayPair {
  std::uint32_t ray = 0;  ///< Index into RayPairs::rays.
  std::uint32_t day = 0;  ///< Index into RayPairs::days.
  double bend_rad = 0.0;
  double clearance_m = 0.0;
};

struct RayPairs {
  std::vector<std::string> rays;      ///< Names, sorted.
  std::vector<std::string> days;      ///< Names, sorted.
  std::vector<RayPair> pairs;         ///< In the order of the file.
  std::size_t runs = 0;               ///< Distinct runs of a day.
  std::size_t missing = 0;            ///< Rows without a bend or a clearance: not among the pairs.
  bool synthetic = false;             ///< There is a column synthetic_seed.
  std::optional<std::uint64_t> seed;  ///< In its first row.
};

struct RayPairsResult {
  std::optional<RayPairs> pairs;  ///< Empty iff there is an error.
  std::vector<table::Diagnostic> diagnostics;
};

/// A table with the columns ray, run, day, bend_rad, clearance_m; others are not looked at. A row
/// without a bend or a clearance is left out and counted. Errors: a cell that is no number, an
/// empty name; more than a fifth of the bends beyond 3.2 rad (degrees?) or of the clearances beyond
/// 10 m (millimetres?), fewer are warnings; a negative clearance is a warning
/// and counts as 0. O(size).
[[nodiscard]] RayPairsResult read_ray_pairs(const table::Bytes& bytes,
                                            const table::CsvOptions& csv);

/// The same from a file, expanded if it ends in .gz or .zst.
[[nodiscard]] RayPairsResult read_ray_pairs(const std::filesystem::path& path,
                                            table::CsvOptions csv = {});

}  // namespace tcert
