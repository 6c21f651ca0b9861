#pragma once
/// \file
/// What rules may speak of: one number a tick and signal.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tcert/certifier.hpp>
#include <tcert/command.hpp>
#include <tcert/felt_points.hpp>
#include <tcert/guards.hpp>
#include <tcert/robot.hpp>
#include <tcert/tick.hpp>
#include <vector>

namespace tcert {

struct SignalDoc {
  std::string_view name;
  std::string_view unit;  ///< Empty if it has none.
  std::string_view doc;   ///< One line, no full stop.
};

/// All signals, in the order of their values.
[[nodiscard]] std::span<const SignalDoc> tick_signals() noexcept;
inline constexpr std::size_t kTickSignals = 22;

/// The place of a signal, if there is one of that name.
[[nodiscard]] std::optional<std::size_t> signal_named(std::string_view name) noexcept;

/// NaN where a signal is not known.
using SignalValues = std::array<double, kTickSignals>;

/// Takes the ticks of one run. The constructor takes all memory; every other member is noexcept.
class TickSignals {
 public:
  /// \pre robot and parameters are valid.
  TickSignals(const Robot& robot, const CertificateParameters& parameters);

  void reset() noexcept;

  /// `commanded` is what the robot was told to drive when the tick was felt; NaN if nobody knows.
  [[nodiscard]] SignalValues take(const Tick& tick,
                                  const CertifiedTick& certified,
                                  const GuardedTick& guarded,
                                  double risk_ahead,
                                  const Command& commanded) noexcept;

 private:
  void compare_rays(const Tick& tick, double gap_s, SignalValues& now) noexcept;

  struct LastReading {
    double value = kMissing;
    double clear_m = kMissing;
    double unchanged_s = 0.0;
  };
  std::vector<Ray> rays_;
  FeltPoints felt_;
  double longest_m_ = 0.0;  // of a ray
  std::vector<LastReading> last_;
  bool began_ = false;
  std::int64_t first_ns_ = 0;
  std::int64_t last_ns_ = 0;
  Point last_position_;
};

}  // namespace tcert
