#pragma once
/// \file
/// The logs of one trial with faults in them.

#include <cstdint>
#include <string>
#include <table/diagnostic.hpp>
#include <vector>

#include "datasets/bundle.hpp"
#include "datasets/perturb/draw_faults.hpp"
#include "datasets/perturb/fault.hpp"

namespace tcert::perturb {

/// What is to be done to every trial of a bundle.
struct PerturbPlan {
  FaultOptions faults;
  std::vector<StreamKind> links;  ///< Streams that lose samples, and whose samples are late.
  std::uint64_t seed = 1;
};

/// A file of a trial that takes the place of another.
struct PerturbedFile {
  std::string source;  ///< "logs/t1/pose.csv.gz", as the bundle has it.
  std::string name;    ///< "logs/t1/pose.csv".
  std::string text;
};

/// What happened to a stream.
struct PerturbedStream {
  std::string name;                    ///< "pose.csv".
  StreamKind kind = StreamKind::pose;  ///< Of ticks.csv tactile.
  std::vector<Injection> injections;
  std::size_t samples = 0;  ///< Rows that it had, met or not.
};

struct PerturbedTrial {
  bool rejected = false;  ///< It has no log that can be read: nothing is done to it.
  std::vector<table::Diagnostic> diagnostics;
  std::vector<PerturbedFile> files;      ///< Of streams that a fault met.
  std::vector<PerturbedStream> streams;  ///< Every injection met a sample.
};

/// A trial's time, to which its faults keep, is that in which both pose and tactile have samples;
/// of ticks.csv all of it. Trials that are longer than 2^24 ticks of 0.1 s are rejected, and so
/// are, if latency is asked for, trials of ticks.csv: ticks have no arrivals. Thread-safe. Never
/// throws on bad content.
[[nodiscard]] PerturbedTrial perturb_trial(const Bundle& bundle,
                                           const TrialRow& trial,
                                           const PerturbPlan& plan);

}  // namespace tcert::perturb
