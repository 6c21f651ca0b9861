#pragma once
/// \file
/// What is to be said of the readings of a log's range rays: values that may mean something else
/// than a distance.

#include <span>
#include <string>
#include <table/diagnostic.hpp>
#include <tcert/robot.hpp>
#include <vector>

#include "datasets/range_rule.hpp"

namespace tcert {

/// One line a kind for all rays of `file`, by what was counted of each:
///
/// - a warning of readings below 0, which are missing;
/// - a warning of one value that makes up over 5 % of a ray's readings and may stand for "nothing
///   within reach" or "no reading": 0; or the largest reading, if it is a code that sensors use
///   (65.535, 8.191, 9.999), or lies beyond the reach and either a fifth above all others or at a
///   fifth of the readings. Standing before a wall repeats neither; a sensor that ends at the reach
///   itself says what it means;
/// - notes of readings below range_min_m and above range_max_m, which are missing.
///
/// \pre as many counts as `robot` has rays.
[[nodiscard]] std::vector<table::Diagnostic> range_report(const Robot& robot,
                                                          std::span<const RangeCount> counts,
                                                          const std::string& file);

}  // namespace tcert
