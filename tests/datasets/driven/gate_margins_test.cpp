#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "datasets/corpus/design.hpp"
#include "datasets/driven/driven_world.hpp"

namespace tcert {
namespace {

struct Moments {
  double mean = 0.0;
  double sd = 0.0;
  double correlation = 0.0;  ///< Of a world's first gate and its last.
  double below = 0.0;        ///< Share below mean - sd.
};

Moments moments_of(const DriveParameters& parameters, std::uint64_t worlds) {
  Moments m;
  std::vector<double> first;
  std::vector<double> last;
  for (std::uint64_t k = 0; k < worlds; ++k) {
    const auto margins = draw_gated_world(parameters, 9, k).gate_margins_m;
    first.push_back(margins.front());
    last.push_back(margins.back());
  }
  const auto n = static_cast<double>(worlds);
  const auto mean_of = [n](const std::vector<double>& x) {
    double sum = 0.0;
    for (const double v : x) {
      sum += v;
    }
    return sum / n;
  };
  const auto product = [&](const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      sum += (x[i] - mean_of(x)) * (y[i] - mean_of(y));
    }
    return sum / (n - 1.0);
  };
  m.mean = mean_of(first);
  m.sd = std::sqrt(product(first, first));
  m.correlation = product(first, last) / std::sqrt(product(first, first) * product(last, last));
  const double edge = parameters.gate_margin_m - parameters.gate_sd_m;
  m.below =
      static_cast<double>(std::ranges::count_if(first, [&](double v) { return v < edge; })) / n;
  return m;
}

// Standard errors of n normal pairs: sd / sqrt(n), sd / sqrt(2 n), (1 - r^2) / sqrt(n); of a share
// p sqrt(p (1 - p) / n). Four of each.
TEST(GatedWorld, HasTheDeclaredMomentsOfItsGates) {
  constexpr std::uint64_t kWorlds = 2000;
  const double root = std::sqrt(static_cast<double>(kWorlds));
  for (const double correlation : {0.0, 0.5, 0.9, 1.0}) {
    DriveParameters parameters;
    parameters.choice = WorldChoice::any;
    parameters.gate_correlation = correlation;
    parameters.blocked_share = 0.0;
    parameters.day_sd_m = 0.0;
    const Moments m = moments_of(parameters, kWorlds);
    EXPECT_NEAR(m.mean, 0.060, 4.0 * 0.045 / root);
    EXPECT_NEAR(m.sd, 0.045, 4.0 * 0.045 / root / std::sqrt(2.0));
    EXPECT_NEAR(m.correlation, correlation, 4.0 * (1.0 - correlation * correlation) / root + 1e-9);
    EXPECT_NEAR(m.below, 0.15866, 4.0 * std::sqrt(0.15866 * 0.84134) / root);
  }
}

// The day's level shifts every gate of its 30 worlds, and with it the lane, by the same.
TEST(GatedWorld, IsShiftedByItsDay) {
  DriveParameters parameters;
  parameters.choice = WorldChoice::any;
  parameters.blocked_share = 0.0;
  DriveParameters without = parameters;
  without.day_sd_m = 0.0;
  std::set<double> shifts;
  int compared = 0;
  for (std::uint64_t k = 0; k < 90; ++k) {
    const DrivenWorld shifted = draw_gated_world(parameters, 6, k);
    const DrivenWorld plain = draw_gated_world(without, 6, k);
    EXPECT_EQ(shifted.day, k / 30);
    const double shift = 0.029 * day_effect(6, k / 30).level;
    EXPECT_EQ(shifted.calibration_bias_m, day_effect(6, k / 30).calibration_m);
    shifts.insert(shift);
    if (shifted.gate_margins_m.size() != plain.gate_margins_m.size()) {
      continue;  // a lane of another width may have no room for its second gate
    }
    ++compared;
    for (std::size_t i = 0; i < plain.gate_margins_m.size(); ++i) {
      EXPECT_NEAR(shifted.gate_margins_m[i] - plain.gate_margins_m[i], shift, 1e-12);
    }
  }
  EXPECT_GT(compared, 60);
  EXPECT_EQ(shifts.size(), 3U);
}

// Lanes are blocked on their own, at 0.2: a binomial of 4 n; a lobe of two blocked lanes is shut.
TEST(GatedWorld, BlocksLanesAtTheDeclaredShare) {
  constexpr int kWorlds = 1000;
  DriveParameters parameters;
  parameters.choice = WorldChoice::any;
  parameters.blocked_share = 0.2;
  parameters.gate_sd_m = 0.0;
  parameters.day_sd_m = 0.0;
  int blocked = 0;
  int shut = 0;
  for (std::uint64_t k = 0; k < kWorlds; ++k) {
    const DrivenWorld world = draw_gated_world(parameters, 2, k);
    for (const double margin : world.gate_margins_m) {
      EXPECT_TRUE(std::abs(margin - 0.06) < 1e-12 || std::abs(margin + 0.4) < 1e-12);
      blocked += margin < 0.0 ? 1 : 0;
    }
    shut += *world.margin_m < 0.0 ? 1 : 0;
  }
  EXPECT_NEAR(blocked, 4 * kWorlds * 0.2, 4.0 * std::sqrt(4 * kWorlds * 0.16));
  const double p = 1.0 - (1.0 - 0.04) * (1.0 - 0.04);
  EXPECT_NEAR(shut, kWorlds * p, 4.0 * std::sqrt(kWorlds * p * (1.0 - p)));
}

}  // namespace
}  // namespace tcert
