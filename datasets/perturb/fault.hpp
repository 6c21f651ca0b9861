#pragma once
/// \file
/// Faults of sensors and of their links, as they are put into the logs of a bundle.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tcert/robot.hpp>
#include <vector>

namespace tcert::perturb {

enum class FaultKind : std::uint8_t {
  dropout,  ///< Samples of a stream are lost.
  latency,  ///< Samples of a stream arrive at once, at the end of a burst.
  spike,    ///< A force at the tip of a ray that nothing exerts.
  freeze,   ///< A ray says again and again what it said last.
  wide,     ///< A ray is stuck at a clearance near the longest that it can state, without force.
  bias,     ///< A ray reads a clearance that is off by a constant.
};

inline constexpr std::array kFaultKinds{FaultKind::dropout,
                                        FaultKind::latency,
                                        FaultKind::spike,
                                        FaultKind::freeze,
                                        FaultKind::wide,
                                        FaultKind::bias};

[[nodiscard]] std::string_view to_string(FaultKind kind) noexcept;

/// How often, how long and how large; a rate of 0, or no good time, is none of the kind. Rates are
/// those of a Poisson process in a trial's time.
struct FaultOptions {
  double dropout_good_s = 0.0;  ///< Mean time without loss; 0: no loss.
  double dropout_bad_s = 1.0;   ///< Mean time of a loss.
  double bursts_per_hour = 0.0;
  double burst_s = 1.0;
  double spikes_per_hour = 0.0;
  double spike_n = 10.0;
  double spike_width_s = 0.2;
  double freezes_per_hour = 0.0;
  double freeze_s = 3.0;
  double wide_per_hour = 0.0;
  double wide_s = 3.0;
  double wide_share = 0.95;  ///< Of the longest clearance that the ray can state.
  double biases_per_hour = 0.0;
  double bias_s = 10.0;
  double bias_m = 0.1;  ///< Above 0 the ray reads too wide.
  bool bias_whole_trial = false;

  [[nodiscard]] bool any() const noexcept;
};

/// One fault in one stream, from start_ns on and before end_ns.
struct Injection {
  FaultKind kind = FaultKind::dropout;
  std::optional<std::size_t> ray{};  ///< Index into the robot's rays; of faults of a ray.
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;
  double size = 0.0;        ///< See injections.csv.
  std::size_t samples = 0;  ///< Of the stream, that are lost, late or say something else.
};

/// What injections.csv says of the size of a fault: "samples", "s", "N", "rad" or "m".
[[nodiscard]] std::string_view unit_of(const Injection& one, std::span<const Ray> rays) noexcept;

/// The header of injections.csv, with its line end.
[[nodiscard]] std::string injections_header();

/// Appends one row of it.
void append_injection(std::string& out,
                      const std::string& trial_id,
                      std::string_view stream,
                      const Injection& one,
                      std::span<const Ray> rays);

}  // namespace tcert::perturb
