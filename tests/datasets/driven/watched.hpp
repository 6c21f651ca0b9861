#pragma once
/// \file
/// Driven trials with the truth beside their logs.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "datasets/driven/driven_trial.hpp"
#include "datasets/driven/scripted.hpp"

namespace tcert::driven_test {

inline constexpr double kContactOff = 0.3;  // N: contact_off_n

struct TrackPoint {
  std::int64_t time_ns = 0;
  Pose pose;
  double speed_mps = 0.0;
};

/// A driven trial with the truth beside it.
struct Watched {
  DrivenDesign design;
  DrivenTrial driven;
  std::vector<TrackPoint> track;
  std::size_t bumps_given = 0;
};

inline Watched watched_trial(std::uint64_t index) {
  Watched watched;
  watched.design = design_driven(uncrashable(), 1, index);
  watched.design.native_rates = true;
  watched.design.parameters.time_limit_s = 60.0;
  LineDriver driver(watched.design.world, 0.2);
  DrivenRun run(watched.design);
  while (const policies::Senses* senses = run.next()) {
    const std::int64_t now = senses->tick.time_ns;
    watched.track.push_back({now, run.body().pose(), run.body().speed_mps()});
    watched.bumps_given += senses->bump ? 1 : 0;
    run.take(driver(*senses));
  }
  watched.driven = trial_of(run);
  return watched;
}

/// 40 trials at 0.2 m/s, of 60 s at most, that no force ends.
inline const std::vector<Watched>& study() {
  static const std::vector<Watched> kStudy = [] {
    std::vector<Watched> all;
    for (std::uint64_t i = 0; i < 40; ++i) {
      all.push_back(watched_trial(i));
    }
    return all;
  }();
  return kStudy;
}

}  // namespace tcert::driven_test
