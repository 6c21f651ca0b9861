#pragma once
/// \file
/// What a pass through a gate felt (paper 3.4): the bottleneck margin, and the certificate before
/// it.

#include <optional>
#include <span>
#include <tcert/certifier.hpp>

namespace tcert::study {

struct GatePass {
  /// Smallest tick margin: min gamma_e over the edges walked once, the pending edge included, since
  /// a pass that is held in the throat does not close it. Empty without a fresh tick.
  std::optional<double> bottleneck_m;
  /// Smallest tc_t before the gate is felt: more than `approach_m` of travel before the tick with
  /// the smallest margin. Empty if there is no such tick.
  std::optional<double> before_m;
};

/// O(ticks). `approach_m` is the body width: the trailing window of the clearance.
[[nodiscard]] GatePass gate_pass(std::span<const CertifiedTick> series, double approach_m);

}  // namespace tcert::study
