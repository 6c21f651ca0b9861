#pragma once
/// \file
/// The Pareto front of points of which both coordinates are better if larger.

#include <span>
#include <vector>

namespace tcert::study {

struct GainAndRetention {
  double gain = 0.0;
  double retention = 0.0;
};

/// True for each point that no other one beats: as good in both and better in one. Equal points
/// stand or fall together; a point with a NaN is on no front and beats none. O(n^2).
[[nodiscard]] std::vector<bool> pareto_front(std::span<const GainAndRetention> points);

}  // namespace tcert::study
