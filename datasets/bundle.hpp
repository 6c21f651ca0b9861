#pragma once
/// \file
/// The log bundle, version 1: a folder or a .zip with bundle.json, trials.csv and logs/.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/range_rule.hpp"

namespace tcert {

enum class EndReason { unknown, goal, collision, wedged, timeout, aborted };

/// One row of trials.csv.
struct TrialRow {
  std::string trial_id;
  std::string algorithm;  ///< Empty if not given, as are the next three.
  std::string lighting;
  std::string day;
  std::string batch;
  std::optional<bool> success;
  std::optional<double> time_s;
  std::optional<double> distance_m;
  EndReason end_reason = EndReason::unknown;
  std::vector<std::string> extra;  ///< One cell per Bundle::extra_columns.
};

/// Where the ticks of a trial begin.
enum class StartAt {
  both,  ///< When both required streams have begun.
  pose,  ///< With the poses; ticks before the first touch are stale.
};

/// Everything in bundle.json.
struct BundleInfo {
  bool synthetic = false;
  std::optional<std::uint64_t> seed;
  std::string provenance;
  Robot robot;
  std::vector<RangeKeys> range_keys;  ///< Of the rays, in their order; may be shorter.
  Course course;
  std::vector<std::string> lighting_tiers;
  std::optional<double> trial_limit_s;
  double max_gap_s = 1.0;  ///< A longer step in a stream's clock is a break of the path.
  StartAt start_at = StartAt::both;
  /// Foreign column name -> ours, per file name ("pose.csv").
  std::map<std::string, std::map<std::string, std::string>> columns;
  /// Parameters that this bundle wants other than the defaults, by key, as text.
  std::map<std::string, std::string> parameters;
};

/// A bundle opened for reading: its description and its trials, not yet their logs.
struct Bundle {
  std::filesystem::path path;  ///< Folder or .zip.
  bool decimal_comma = false;  ///< As asked for when it was opened.
  BundleInfo info;
  std::vector<std::string> extra_columns;
  std::vector<TrialRow> trials;  ///< In file order.
};

struct BundleResult {
  std::optional<Bundle> bundle;  ///< Empty iff it cannot be used at all.
  std::vector<table::Diagnostic> diagnostics;
};

struct BundleOptions {
  bool decimal_comma = false;  ///< Numbers like 1,5 in files whose separator is the semicolon.
};

/// Reads bundle.json and trials.csv. Never throws on bad content; every problem of both files is
/// in the diagnostics. A trial row with an error is left out of `trials` and named there.
[[nodiscard]] BundleResult open_bundle(const std::filesystem::path& path,
                                       const BundleOptions& options = {});

struct BundleInfoResult {
  std::optional<BundleInfo> info;  ///< Empty iff it cannot be used.
  std::vector<table::Diagnostic> diagnostics;
};

/// Reads bundle.json alone: the rest of the bundle need not be there.
[[nodiscard]] BundleInfoResult read_bundle_info(const std::filesystem::path& path);

}  // namespace tcert
