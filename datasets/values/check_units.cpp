#include "datasets/values/check_units.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "datasets/tick_columns.hpp"

namespace tcert {
namespace {

constexpr std::size_t kLeastReadings = 20;
constexpr double kBeyondShare = 0.2;
constexpr double kAbsurdShare = 0.01;
constexpr double kHeavyShare = 0.01;
constexpr double kHalf = 0.5;
constexpr double kOneTurn = 2.0 * std::numbers::pi;
constexpr double kMarginOfSpan = 0.1;  // noise of a free tentacle lies outside its calibration
constexpr double kReaches = 2.0;       // a range may be longer than what counts of it
constexpr double kFarReaches = 10.0;
constexpr double kCentimetres = 120.0;  // with noise above the reach
constexpr double kLeftOver = 0.1;
constexpr double kHeaviestTipN = 50.0;
constexpr double kFarMountM = 4.0;  // a lorry's

/// A ray of a trial, with what its readings were.
struct Looked {
  const Ray& ray;
  const RayScan& scan;
  const TrialScan& trial;
  const TickTable& ticks;
  std::size_t k;

  template <class Predicate>
  [[nodiscard]] double share_of_known(Predicate holds) const {
    return static_cast<double>(
               count_readings(ticks, trial, k, [&](RayReading r) { return holds(r.value); })) /
           static_cast<double>(scan.known);
  }
};

std::optional<ValueFinding> check_mount(const Ray& ray) {
  const double away_m = std::hypot(ray.mount.x_m, ray.mount.y_m);
  if (away_m <= kFarMountM) {
    return std::nullopt;
  }
  return value_finding(ValueKind::mount_unit,
                       ray.name,
                       fmt::format("mounted {:g} m from the body's centre", away_m),
                       "mount_x_m and mount_y_m in metres: millimetres, centimetres?");
}

std::optional<ValueFinding> check_bend(const Looked& of) {
  const std::vector<double>& bend = of.ray.calibration.bend_rad;
  // One knot is a clearance whatever the bend: nothing lies outside of it.
  const double margin = bend.size() > 1 ? kMarginOfSpan * (bend.back() - bend.front()) : kOneTurn;
  const double low = bend.front() - margin;
  const double high = bend.back() + margin;
  if (of.scan.least >= low && of.scan.largest <= high) {
    return std::nullopt;
  }
  const double beyond = of.share_of_known([=](double v) { return v < low || v > high; });
  const double absurd = of.share_of_known([](double v) { return std::abs(v) > kOneTurn; });
  if (beyond <= kBeyondShare && absurd <= kAbsurdShare) {
    return std::nullopt;
  }
  const bool outside = beyond > kBeyondShare;
  return value_finding(
      ValueKind::bend_unit,
      value_column(of.ray),
      fmt::format("{:.0f} % beyond {:.3g} rad, up to {:g}",
                  std::ceil(100.0 * (outside ? beyond : absurd)),
                  outside ? high : kOneTurn,
                  of.scan.largest),
      fmt::format(
          "radians within the calibration, {:g} to {:g}: degrees?", bend.front(), bend.back()));
}

std::optional<ValueFinding> check_range(const Looked& of) {
  const double reach_m = of.ray.reach_m;
  const auto share_above = [&](double limit) {
    return of.share_of_known([=](double v) { return v > limit; });
  };
  if (of.scan.largest <= kReaches * reach_m) {
    return std::nullopt;
  }
  const double beyond = share_above(kReaches * reach_m);
  if (beyond <= kBeyondShare) {
    return std::nullopt;
  }
  const char* const guess = share_above(kFarReaches * reach_m) <= kBeyondShare
                                ? "a longer reach_m for a sensor that sees so far, or centimetres?"
                            : share_above(kCentimetres * reach_m) <= kLeftOver ? "centimetres?"
                                                                               : "millimetres?";
  return value_finding(ValueKind::range_unit,
                       value_column(of.ray),
                       fmt::format("{:.0f} % beyond {:g} m, up to {:g}",
                                   100.0 * beyond,
                                   kReaches * reach_m,
                                   of.scan.largest),
                       fmt::format("metres up to about the reach of {:g} m: {}", reach_m, guess));
}

std::optional<ValueFinding> check_bearing(const Looked& of) {
  double largest_rad = 0.0;
  (void)count_readings(of.ticks, of.trial, of.k, [&](RayReading reading) {
    largest_rad = std::fmax(largest_rad, std::abs(reading.bearing_rad));
    return false;
  });
  if (is_usable_bearing(largest_rad)) {
    return std::nullopt;
  }
  return value_finding(ValueKind::bearing_unit,
                       bearing_column(of.ray),
                       fmt::format("angles up to {:g}", largest_rad),
                       "radians from the heading: degrees? Such a reading counts as missing");
}

std::optional<ValueFinding> check_force(const Looked& of, const CertificateParameters& parameters) {
  if (of.scan.largest_force_n <= kHeaviestTipN) {
    return std::nullopt;
  }
  const auto count = [&](auto holds) {
    return static_cast<double>(count_readings(
        of.ticks, of.trial, of.k, [&](RayReading reading) { return holds(reading.fsr_n); }));
  };
  const double known = count([](double f) { return !std::isnan(f); });
  const double heavy = count([](double f) { return f > kHeaviestTipN; });
  const double pressed = count([&](double f) { return f >= parameters.contact_on_n; });
  const bool is_wrong =
      heavy > kHalf * known || (heavy > kHeavyShare * known && pressed > kHalf * known);
  if (known < static_cast<double>(kLeastReadings) || !is_wrong) {
    return std::nullopt;
  }
  return value_finding(ValueKind::force_unit,
                       force_column(of.ray),
                       fmt::format("{:.0f} % above {:g} N, up to {:g}",
                                   100.0 * heavy / known,
                                   kHeaviestTipN,
                                   of.scan.largest_force_n),
                       "newtons at the tip of a ray: grams?");
}

}  // namespace

std::vector<ValueFinding> check_units(const Robot& robot,
                                      const CertificateParameters& parameters,
                                      const TickTable& ticks,
                                      const TrialScan& scan) {
  std::vector<ValueFinding> found;
  for (std::size_t k = 0; k < scan.rays.size(); ++k) {
    const Looked of{robot.rays[k], scan.rays[k], scan, ticks, k};
    if (auto one = check_mount(of.ray)) {
      found.push_back(std::move(*one));
    }
    if (of.scan.known >= kLeastReadings) {
      if (auto one = of.ray.kind == RayKind::bend ? check_bend(of) : check_range(of)) {
        found.push_back(std::move(*one));
      }
    }
    if (auto one = check_bearing(of)) {
      found.push_back(std::move(*one));
    }
    if (auto one = check_force(of, parameters)) {
      found.push_back(std::move(*one));
    }
  }
  return found;
}

}  // namespace tcert
