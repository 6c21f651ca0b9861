#pragma once
/// \file
/// The bottleneck micro-study (paper 3.4): does the margin at a gate tell whether the robot passes,
/// and is the even chance at margin 0?

#include <cstddef>
#include <optional>
#include <statistics/basics/interval.hpp>
#include <statistics/logistic/logistic.hpp>
#include <string>
#include <vector>

#include "analysis/study/gate/even_chance.hpp"
#include "analysis/study/gate/gate_pass.hpp"

namespace tcert::study {

struct GateRow {
  std::string trial_id;
  std::optional<bool> success;
  GatePass pass;
};

/// Passes of like margin: what was seen and what the model says.
struct GateCalibration {
  std::size_t passes = 0;
  std::size_t successes = 0;
  double mean_margin_m = 0.0;
  double observed = 0.0;
  statistics::Interval observed_interval;  ///< Wilson.
  double predicted = 0.0;                  ///< Mean of the fitted chances.
};

/// The fitted chance at a margin, with its pointwise Wald interval on the logit scale.
struct GateChance {
  double margin_m = 0.0;
  double chance = 0.0;
  statistics::Interval interval;
};

struct GateStudy {
  std::vector<GateRow> rows;
  EvenChance even;  ///< x is the bottleneck margin in metres.
  std::optional<statistics::LogisticFit>
      both;  ///< success ~ bottleneck + certificate before the gate.
  std::vector<GateCalibration> calibration;  ///< Of five groups of about equal size, by margin.
  std::vector<GateChance> curve;  ///< Over the range of the margins; empty without a fit.
  std::size_t incomplete = 0;     ///< Passes without outcome or bottleneck margin, left out.
  EvenChanceOptions options;
};

/// \throws std::invalid_argument as `even_chance`.
[[nodiscard]] GateStudy gate_study(std::vector<GateRow> rows, const EvenChanceOptions& options);

}  // namespace tcert::study
