#include "analysis/study/replay/replay.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "analysis/study/trials/motion.hpp"

namespace tcert::study {
namespace {

constexpr double kNanosecond = 1e-9;

/// The fresh ticks of a run up to the first inside G.
struct Path {
  std::vector<std::size_t> index;
  std::vector<TimedPosition> positions;
  std::vector<Motion> motion;
};

Path path_of(const TickTable& ticks,
             std::span<const CertifiedTick> series,
             const ReplayOptions& options) {
  Path path;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const std::uint32_t flags = series[i].flags;
    if ((flags & (flag_stale | flag_bad_input)) != 0) {
      continue;
    }
    path.index.push_back(i);
    path.positions.push_back(
        {ticks.time_ns[i], ticks.poses[i].position, (flags & flag_break) != 0});
    if ((flags & flag_goal_reached) != 0) {
      break;
    }
  }
  path.motion = trailing_motion(
      path.positions, static_cast<std::int64_t>(std::llround(options.slow_window_s * 1e9)));
  return path;
}

/// Values that hold for a time each.
class TimedValues {
 public:
  void add(double value, double time_s) {
    if (!std::isnan(value) && time_s > 0.0) {
      values_.emplace_back(value, time_s);
    }
  }

  /// The least value that, with all below it, holds for half of the time.
  [[nodiscard]] std::optional<double> median() {
    std::sort(values_.begin(), values_.end());
    double total = 0.0;
    for (const auto& [value, time_s] : values_) {
      total += time_s;
    }
    double below = 0.0;
    for (const auto& [value, time_s] : values_) {
      below += time_s;
      if (below >= 0.5 * total) {
        return value;
      }
    }
    return std::nullopt;
  }

 private:
  std::vector<std::pair<double, double>> values_;
};

/// Forward path without speed, until a tick has speed again.
class Stretch {
 public:
  Stretch(Replay& replay, double stall_m) : replay_(replay), stall_m_(stall_m) {}

  void add(double length_m) { length_m_ += length_m; }
  void end() {
    // Sums of steps: five of 1 cm are 5 cm.
    if (length_m_ >= stall_m_ * (1.0 - 1e-12)) {
      ++replay_.stalls;
      replay_.stall_m += length_m_;
    } else {
      replay_.creep_m += length_m_;
    }
    length_m_ = 0.0;
  }

 private:
  Replay& replay_;
  double stall_m_;
  double length_m_ = 0.0;
};

void count_trips(std::span<const ActedTick> acted, std::size_t last, Replay& replay) {
  for (std::size_t i = 0; i <= last; ++i) {
    const std::uint32_t began = acted[i].guarded.began;
    replay.margin_trips += (began & guard_margin) != 0 ? 1 : 0;
    replay.force_trips += (began & guard_force) != 0 ? 1 : 0;
    replay.replan_trips += (began & guard_replan) != 0 ? 1 : 0;
    replay.alarms += static_cast<std::size_t>(std::popcount(acted[i].alarms_began));
  }
}

}  // namespace

void validate(const ReplayOptions& options) { require_fields(options); }

std::optional<double> rate_of_advance(double length_m, double time_s) {
  return time_s > 0.0 ? std::optional(60.0 * length_m / time_s) : std::nullopt;
}

std::vector<ActedTick> act_trial(TickActions& actions,
                                 const TickTable& ticks,
                                 std::span<const CertifiedTick> series) {
  if (series.size() != ticks.size()) {
    throw std::invalid_argument("replay: series and ticks differ in length");
  }
  actions.reset();
  std::vector<ActedTick> acted;
  acted.reserve(ticks.size());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    acted.push_back(actions.update(ticks[i], series[i], ticks.commanded(i)));
  }
  return acted;
}

Replay replay(const TickTable& ticks,
              std::span<const CertifiedTick> series,
              std::span<const ActedTick> acted,
              const ReplayOptions& options) {
  if (series.size() != ticks.size() || acted.size() != ticks.size()) {
    throw std::invalid_argument("replay: series and ticks differ in length");
  }
  validate(options);
  const Path path = path_of(ticks, series, options);
  Replay result;
  Stretch stretch(result, options.stall_m);
  TimedValues commanded;
  TimedValues gated;
  for (std::size_t k = 1; k < path.index.size(); ++k) {
    const std::size_t from = path.index[k - 1];
    const std::size_t to = path.index[k];
    const GuardedTick& guard = acted[from].guarded;
    const double command_mps = ticks.speed_cmd_mps.empty() ? kMissing : ticks.speed_cmd_mps[from];
    const double elapsed_s =
        kNanosecond * static_cast<double>(ticks.time_ns[to] - ticks.time_ns[from]);
    const Point step = ticks.poses[to].position - ticks.poses[from].position;
    const double length_m = norm(step);
    const double speed_mps = path.motion[k].speed_mps.value_or(length_m / elapsed_s);
    if (!guard.halted()) {
      stretch.end();
    }
    result.time_s += elapsed_s;
    commanded.add(command_mps, elapsed_s);
    if (path.positions[k].after_break || speed_mps < options.slow_speed_mps) {
      result.slow_s += elapsed_s;
      result.gated_time_s += elapsed_s;
      gated.add(command_mps, elapsed_s);
      continue;
    }
    if (guard.halted() && dot(step, direction(ticks.poses[from].yaw_rad)) >= 0.0) {
      stretch.add(length_m);
    }
    const double gated_mps = guard.halted() ? guard.retreat_speed_mps : guard.speed_mps;
    result.length_m += length_m;
    result.gated_time_s += length_m / gated_mps;
    gated.add(gated_mps, length_m / gated_mps);
  }
  stretch.end();
  result.speed_cmd_mps = commanded.median();
  result.gated_speed_cmd_mps = gated.median();
  if (!path.index.empty()) {
    count_trips(acted, path.index.back(), result);
  }
  return result;
}

bool keeps_success(const Replay& replay, std::optional<double> limit_s) {
  return replay.stalls == 0 && (!limit_s || replay.gated_time_s <= *limit_s);
}

}  // namespace tcert::study
