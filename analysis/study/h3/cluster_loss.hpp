#pragma once
/// \file
/// Non-inferiority of a share of trials that are alike within clusters.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tcert::study {

/// Trials that are alike count as fewer: trials / design_effect.
struct ClusterLoss {
  std::size_t lost = 0;
  std::size_t trials = 0;
  double design_effect = 1.0;
  /// Clopper-Pearson of the effective trials, one-sided each. Empty without trials.
  std::optional<double> lower, upper;
  std::optional<double> p;  ///< Of the share being the margin or more.

  [[nodiscard]] double effective_trials() const noexcept {
    return static_cast<double>(trials) / design_effect;
  }
};

/// The intraclass correlation of 0/1 values by analysis of variance (Donner and Klar 2000), between
/// 0 and 1; 0 without spread.
[[nodiscard]] double binary_icc(std::span<const std::uint8_t> values,
                                std::span<const std::uint32_t> cluster);

/// The design effect is 1 + (sum n_g^2 / n - 1) times the larger correlation of what was lost and
/// of what had failed anyway, which stands in where nearly nothing is lost and the data cannot
/// say: losses are taken to be no more alike than failures. Every span is one value a trial.
/// \throws std::invalid_argument if lengths differ.
[[nodiscard]] ClusterLoss cluster_loss(std::span<const std::uint8_t> lost,
                                       std::span<const std::uint8_t> failed,
                                       std::span<const std::uint32_t> cluster,
                                       double level,
                                       double margin);

/// The least number of independent trials with which a true share `lost` is found below `margin` by
/// the one-sided bound with this power, and with any more. Empty if lost >= margin, or beyond 10^5
/// trials.
[[nodiscard]] std::optional<double> trials_for_power(double lost,
                                                     double margin,
                                                     double level,
                                                     double power);

}  // namespace tcert::study
