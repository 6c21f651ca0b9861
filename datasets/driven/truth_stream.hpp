#pragma once
/// \file
/// What really happened in a driven trial, sample by sample: truth.csv beside its logs.

#include <cstdint>
#include <optional>
#include <string>
#include <table/diagnostic.hpp>
#include <tcert/geometry.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/corpus/wall_index.hpp"
#include "datasets/driven/body.hpp"

namespace tcert {

struct TruthSample {
  std::int64_t time_ns = 0;
  Pose pose;                  ///< Without noise.
  double speed_mps = 0.0;     ///< Along the heading; negative in reverse.
  double force_n = 0.0;       ///< Largest contact force on the body since the sample before.
  double free_ahead_m = 0.0;  ///< How far the body can go straight on, at most kTruthAhead.
};

/// Further than any body here needs to stop.
inline constexpr double kTruthAhead = 0.4;

/// 20 samples a second of the body that is driven. Nothing of it is known to who drives.
class TruthRecorder {
 public:
  /// `walls` outlive the recorder and know of walls within the radius and kTruthAhead.
  TruthRecorder(const WallIndex& walls, double radius_m) : walls_(walls), radius_m_(radius_m) {}

  /// After each step of the body, which ends at `time_ns`.
  void take(std::int64_t time_ns, const Body& body);

  [[nodiscard]] const std::vector<TruthSample>& samples() const noexcept { return samples_; }

 private:
  const WallIndex& walls_;
  double radius_m_;
  double force_n_ = 0.0;
  std::vector<TruthSample> samples_;
};

/// How far a disc can be moved along `ahead` from a place where it is free, at most kTruthAhead: to
/// where it would be 1 mm within a wall, so that a body which slides along one is not held by it.
[[nodiscard]] double free_way(const WallIndex& walls, Point from, Point ahead, double radius_m);

/// The text of truth.csv.
[[nodiscard]] std::string truth_csv(const std::vector<TruthSample>& samples);

struct TruthResult {
  std::optional<std::vector<TruthSample>>
      samples;  ///< Empty if the trial has none that can be read.
  std::vector<table::Diagnostic> diagnostics;
};

/// Reads logs/<trial_id>/truth.csv. Thread-safe.
[[nodiscard]] TruthResult read_truth(const Bundle& bundle, const std::string& trial_id);

}  // namespace tcert
