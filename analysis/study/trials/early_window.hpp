#pragma once
/// \file
/// Cutting a trial's fresh ticks into early windows. Internal to features.cpp.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <tcert/certifier.hpp>
#include <vector>

#include "analysis/study/trials/motion.hpp"
#include "datasets/ticks.hpp"

namespace tcert::study {

[[nodiscard]] std::int64_t nanoseconds_of(double seconds) noexcept;
[[nodiscard]] double seconds_of(std::int64_t nanoseconds) noexcept;

/// The fresh ticks of a trial, with what the windows are cut by. Windows are prefixes of it.
struct FreshTicks {
  std::vector<std::size_t> index;  // in the tick table
  std::vector<std::int64_t> since_start_ns;
  std::vector<double> travel_m;
  std::vector<Motion> motion;

  [[nodiscard]] std::size_t size() const noexcept { return index.size(); }
};

/// \pre `series` is as long as `ticks`, and neither is empty.
[[nodiscard]] FreshTicks fresh_ticks(const TickTable& ticks,
                                     std::span<const CertifiedTick> series,
                                     std::int64_t dwell_window_ns);

/// A window: the first `size` fresh ticks, and when it closed, if it did before the log ended.
struct Window {
  std::size_t size = 0;
  std::optional<double> end_s;
};

/// Ticks with t <= limit_s, in a log that ends at end_ns.
[[nodiscard]] Window time_window(const FreshTicks& fresh, std::int64_t end_ns, double limit_s);

/// Ticks with s <= limit_m and t <= cap_s.
[[nodiscard]] Window distance_window(const FreshTicks& fresh,
                                     std::int64_t end_ns,
                                     double limit_m,
                                     double cap_s);

}  // namespace tcert::study
