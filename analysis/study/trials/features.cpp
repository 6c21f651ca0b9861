#include "analysis/study/trials/features.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <statistics/basics/quantile.hpp>
#include <stdexcept>
#include <vector>

#include "analysis/study/trials/early_window.hpp"

namespace tcert::study {
namespace {

std::optional<double> contacts_per_m(std::span<const CertifiedTick> series,
                                     const FreshTicks& fresh,
                                     std::size_t size) {
  std::uint64_t contacts = 0;
  for (std::size_t k = 0; k < size; ++k) {
    contacts += series[fresh.index[k]].new_contacts;
  }
  const double travel_m = fresh.travel_m[size - 1] - fresh.travel_m[0];
  if (!(travel_m > 0.0)) {
    return std::nullopt;
  }
  return static_cast<double>(contacts) / travel_m;
}

std::optional<double> dwell(const FreshTicks& fresh, std::size_t size, double dwell_speed_mps) {
  std::int64_t slow_ns = 0;
  std::int64_t all_ns = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const Motion& motion = fresh.motion[k];
    if (!motion.speed_mps) {
      continue;
    }
    all_ns += motion.step_ns;
    slow_ns += *motion.speed_mps < dwell_speed_mps ? motion.step_ns : 0;
  }
  if (all_ns == 0) {
    return std::nullopt;
  }
  return static_cast<double>(slow_ns) / static_cast<double>(all_ns);
}

/// Variance of one ray's readings by Welford's recurrence; empty with fewer than two.
std::optional<double> reading_variance(const Ray& ray,
                                       std::size_t ray_index,
                                       const TickTable& ticks,
                                       std::span<const std::size_t> rows) {
  double mean = 0.0;
  double squares = 0.0;
  double count = 0.0;
  for (const std::size_t row : rows) {
    double value = ticks.readings[row * ticks.rays + ray_index].value;
    if (ray.kind == RayKind::range) {
      value = std::clamp(value, 0.0, ray.reach_m) / ray.reach_m;
    }
    if (!std::isfinite(value)) {
      continue;
    }
    count += 1.0;
    const double step = value - mean;
    mean += step / count;
    squares += step * (value - mean);
  }
  if (count < 2.0) {
    return std::nullopt;
  }
  return squares / (count - 1.0);
}

std::optional<double> bend_variance(const Robot& robot,
                                    const TickTable& ticks,
                                    std::span<const std::size_t> rows) {
  double sum = 0.0;
  std::size_t rays = 0;
  for (std::size_t k = 0; k < robot.rays.size(); ++k) {
    if (const auto variance = reading_variance(robot.rays[k], k, ticks, rows)) {
      sum += *variance;
      ++rays;
    }
  }
  if (rays == 0) {
    return std::nullopt;
  }
  return sum / static_cast<double>(rays);
}

/// The features of one window.
struct WindowValues {
  std::optional<double> tc;
  std::optional<double> contacts_per_m;
  std::optional<double> dwell;
  std::optional<double> bend_variance;
};

struct LoggedTrial {
  const Robot& robot;
  const TickTable& ticks;
  std::span<const CertifiedTick> series;
  const FreshTicks& fresh;
  const EarlyWindowOptions& options;
};

WindowValues window_values(const LoggedTrial& trial, const Window& window) {
  if (window.size == 0 || window.size < static_cast<std::size_t>(trial.options.min_ticks)) {
    return {};
  }
  const auto rows = std::span(trial.fresh.index).first(window.size);
  std::vector<double> tc;
  tc.reserve(rows.size());
  for (const std::size_t row : rows) {
    tc.push_back(series_value(trial.series[row]));
  }
  const bool known = std::all_of(tc.begin(), tc.end(), [](double x) { return std::isfinite(x); });
  return {known ? statistics::quantile_in_place(tc, trial.options.quantile) : std::nullopt,
          contacts_per_m(trial.series, trial.fresh, window.size),
          dwell(trial.fresh, window.size, trial.options.dwell_speed_mps),
          bend_variance(trial.robot, trial.ticks, rows)};
}

std::optional<double> smaller(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(std::min(*a, *b)) : std::nullopt;
}

std::optional<double> larger(std::optional<double> a, std::optional<double> b) {
  return a && b ? std::optional(std::max(*a, *b)) : std::nullopt;
}

WindowValues worse(const WindowValues& a, const WindowValues& b) {
  return {smaller(a.tc, b.tc),
          larger(a.contacts_per_m, b.contacts_per_m),
          larger(a.dwell, b.dwell),
          larger(a.bend_variance, b.bend_variance)};
}

std::size_t certificate_falls(std::span<const CertifiedTick> series) {
  std::size_t falls = 0;
  for (std::size_t k = 1; k < series.size(); ++k) {
    falls += series[k].certificate_m < series[k - 1].certificate_m ? 1 : 0;
  }
  return falls;
}

void require(bool holds, const char* what) {
  if (!holds) {
    throw std::invalid_argument(what);
  }
}

}  // namespace

void add_certificate(const TickTable& ticks,
                     std::span<const CertifiedTick> series,
                     Features& features) {
  const CertifiedTick& last = series.back();
  features.issued = last.issued;
  features.issued_s = std::nullopt;
  features.issued_before_goal = std::nullopt;
  if (last.issued) {
    const auto first = std::ranges::find_if(series, &CertifiedTick::issued);
    const auto row = static_cast<std::size_t>(first - series.begin());
    features.issued_s = seconds_of(ticks.time_ns[row] - ticks.time_ns[0]);
    features.issued_before_goal = (first->flags & flag_goal_reached) == 0;
  }
  features.certificate_falls = certificate_falls(series);
  features.certificate_m =
      std::isfinite(last.certificate_m) ? std::optional(last.certificate_m) : std::nullopt;
}

void validate(const EarlyWindowOptions& options) { require_fields(options); }

Features early_features(const Robot& robot,
                        const TickTable& ticks,
                        std::span<const CertifiedTick> series,
                        const EarlyWindowOptions& options) {
  require(series.size() == ticks.size(), "early window: one series row per tick expected");
  require(ticks.rays == robot.rays.size(),
          "early window: the ticks have other rays than the robot");
  Features features;
  if (series.empty()) {
    features.ticks = 0;
    return features;
  }
  const FreshTicks fresh = fresh_ticks(ticks, series, nanoseconds_of(options.dwell_window_s));
  const std::int64_t end_ns = ticks.time_ns.back() - ticks.time_ns.front();
  const LoggedTrial trial{robot, ticks, series, fresh, options};
  features.ticks = ticks.size();
  features.end_s = seconds_of(end_ns);
  features.travel_m = series.back().travel_m;
  add_certificate(ticks, series, features);

  const Window landmark = time_window(fresh, end_ns, options.time_s);
  Window first = landmark;
  Window second = landmark;
  if (options.kind == EarlyWindowKind::both) {
    second = distance_window(fresh, end_ns, options.distance_m, options.distance_cap_s);
  } else if (options.kind == EarlyWindowKind::fraction) {
    const double end_s = seconds_of(end_ns);
    first = time_window(fresh, end_ns, options.fraction * end_s);
    second = distance_window(fresh, end_ns, options.fraction * *features.travel_m, end_s);
  }

  const WindowValues at_landmark = window_values(trial, landmark);
  const WindowValues early = worse(window_values(trial, first), window_values(trial, second));
  features.tc_early = early.tc;
  features.contacts_per_m = early.contacts_per_m;
  features.dwell = early.dwell;
  features.bend_variance = early.bend_variance;
  features.tc_landmark = at_landmark.tc;
  features.contacts_per_m_landmark = at_landmark.contacts_per_m;
  features.dwell_landmark = at_landmark.dwell;
  features.bend_variance_landmark = at_landmark.bend_variance;

  features.ticks_early = std::min(first.size, second.size);
  features.ticks_landmark = landmark.size;
  features.window_end_s = larger(first.end_s, second.end_s);
  if (landmark.size > 0 && fresh.motion[landmark.size - 1].speed_mps) {
    features.still_at_landmark =
        *fresh.motion[landmark.size - 1].speed_mps < options.dwell_speed_mps;
  }
  return features;
}

}  // namespace tcert::study
