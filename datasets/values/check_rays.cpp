#include "datasets/values/check_rays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "datasets/tick_columns.hpp"

namespace tcert {
namespace {

constexpr std::size_t kLeastTicks = 50;
constexpr double kLeastWayM = 1.0;
// Grazing a wall at the end of its reach, a ray reads free as often as not, for up to a fifth of a
// trial's way; one that hangs does so for most of what is left.
constexpr double kLeastFreeShare = 0.5;  // of the readings since the contact began
constexpr double kLeastShareOfWay = 1.0 / 3.0;
constexpr double kSilentShare = 0.1;
constexpr double kSpokenShare = 0.5;

/// The contact of a ray that lasts to the end of the log.
struct LastContact {
  double since_s = 0.0;
  std::size_t known = 0;    // readings since
  std::size_t free = 0;     // of them, within the slack of the longest clearance
  double free_way_m = 0.0;  // way to those ticks
};

/// Where it began, in `scan.fresh`: at the first force of contact_on_n and more that is followed by
/// none below contact_off_n; past the end if there is none.
std::size_t last_contact(const TickTable& ticks,
                         const TrialScan& scan,
                         std::size_t k,
                         const CertificateParameters& parameters) {
  std::size_t began = scan.fresh.size();
  for (std::size_t j = scan.fresh.size(); j-- > 0;) {
    const double force_n = ticks.readings[scan.fresh[j] * ticks.rays + k].fsr_n;
    if (force_n >= parameters.contact_on_n) {
      began = j;
    } else if (force_n < parameters.contact_off_n) {
      break;
    }
  }
  return began;
}

LastContact follow_contact(const Ray& ray,
                           const TickTable& ticks,
                           const TrialScan& scan,
                           std::size_t k,
                           std::size_t began,
                           const CertificateParameters& parameters) {
  const double free_m = longest_clearance(ray) - parameters.contact_slack_m;
  LastContact contact;
  contact.since_s = elapsed_s(ticks.time_ns.front(), ticks.time_ns[scan.fresh[began]]);
  for (std::size_t j = began; j < scan.fresh.size(); ++j) {
    const double value = ticks.readings[scan.fresh[j] * ticks.rays + k].value;
    if (std::isnan(value)) {
      continue;
    }
    ++contact.known;
    const double clearance_m =
        ray.kind == RayKind::bend ? calibrated_clearance(ray.calibration, value) : value;
    if (clearance_m >= free_m) {
      ++contact.free;
      contact.free_way_m +=
          j == began ? 0.0 : scan.way_m[scan.fresh[j]] - scan.way_m[scan.fresh[j - 1]];
    }
  }
  return contact;
}

std::optional<ValueFinding> stuck_contact(const Ray& ray,
                                          const TickTable& ticks,
                                          const TrialScan& scan,
                                          std::size_t k,
                                          const CertificateParameters& parameters) {
  if (scan.rays[k].largest_force_n < parameters.contact_on_n) {
    return std::nullopt;
  }
  const std::size_t began = last_contact(ticks, scan, k, parameters);
  if (began == scan.fresh.size()) {
    return std::nullopt;
  }
  const LastContact contact = follow_contact(ray, ticks, scan, k, began, parameters);
  if (contact.free_way_m < std::max(kLeastWayM, kLeastShareOfWay * scan.last_way_m()) ||
      static_cast<double>(contact.free) < kLeastFreeShare * static_cast<double>(contact.known)) {
    return std::nullopt;
  }
  return value_finding(
      ValueKind::contact_stuck,
      force_column(ray),
      fmt::format("contact from {:.1f} s to the end at {:.1f} s",
                  contact.since_s,
                  elapsed_s(ticks.time_ns.front(), ticks.time_ns[scan.fresh.back()])),
      fmt::format("a contact that ends when its wall is gone: {:.0f} % of the readings since then "
                  "are free, over {:.1f} m of way; check the zero of the force sensor, raise "
                  "contact_off_n, or leave the column out",
                  100.0 * static_cast<double>(contact.free) / static_cast<double>(contact.known),
                  contact.free_way_m));
}

ValueFinding stuck_reading(const Ray& ray, const RayScan& of, const TrialScan& scan) {
  return value_finding(
      ValueKind::ray_stuck,
      value_column(ray),
      fmt::format("{:g} at every tick", of.least),
      fmt::format("a reading that moves along {:.1f} m of way; a sensor that hangs or is not "
                  "plugged in reads so: leave the ray out, or the trial",
                  scan.last_way_m()));
}

/// The first of the fresh ticks from which on a ray reads the same to the end.
std::size_t same_since(const TickTable& ticks, const TrialScan& scan, std::size_t k) {
  const auto value_at = [&](std::size_t j) {
    return ticks.readings[scan.fresh[j] * ticks.rays + k].value;
  };
  std::size_t since = scan.fresh.size() - 1;
  while (since > 0 && value_at(since - 1) == value_at(scan.fresh.size() - 1)) {
    --since;
  }
  return since;
}

/// A reading that moved, and at some time ceases to until the log ends, while another ray's goes on
/// to `moving_until`: along a straight wall all may be still.
std::optional<ValueFinding> hung(const Ray& ray,
                                 const TickTable& ticks,
                                 const TrialScan& scan,
                                 std::size_t k,
                                 std::size_t moving_until) {
  const std::size_t since = same_since(ticks, scan, k);
  const double last = ticks.readings[scan.fresh.back() * ticks.rays + k].value;
  const double clearance_m =
      ray.kind == RayKind::bend ? calibrated_clearance(ray.calibration, last) : last;
  const double way_m = scan.last_way_m() - scan.way_m[scan.fresh[since]];
  if (scan.fresh.size() - since < kLeastTicks || moving_until < since + kLeastTicks ||
      !(clearance_m < longest_clearance(ray)) ||
      way_m < std::max(kLeastWayM, kLeastShareOfWay * scan.last_way_m())) {
    return std::nullopt;
  }
  return value_finding(
      ValueKind::ray_hung,
      value_column(ray),
      fmt::format("{:g} at every tick from {:.1f} s to the end",
                  last,
                  elapsed_s(ticks.time_ns.front(), ticks.time_ns[scan.fresh[since]])),
      fmt::format("a reading that goes on moving, over the last {:.1f} m of way too: a sensor that "
                  "hangs, or a logger that repeats its last value",
                  way_m));
}

ValueFinding twin(const Ray& ray, const Ray& earlier, const TrialScan& scan) {
  return value_finding(
      ValueKind::ray_twin,
      value_column(ray),
      fmt::format("the {} readings of {}", scan.fresh.size(), value_column(earlier)),
      "readings of its own: one sensor was logged under two names, or two names lead to one "
      "column; check 'columns' in bundle.json, or leave one ray out");
}

ValueFinding silent(const Ray& ray, const RayScan& of, const TrialScan& scan) {
  return value_finding(
      ValueKind::ray_silent,
      value_column(ray),
      fmt::format("readings at {} of {} ticks", of.known, scan.fresh.size()),
      "readings as the other rays have them: each missing one counts as no wider than the body; "
      "leave the ray out if its sensor is dead");
}

bool are_same(double a, double b) noexcept { return a == b || (std::isnan(a) && std::isnan(b)); }

/// True if two rays read the same at all fresh ticks. Most differ in their extremes already.
bool same_readings(const TickTable& ticks, const TrialScan& scan, std::size_t a, std::size_t b) {
  const RayScan& one = scan.rays[a];
  const RayScan& other = scan.rays[b];
  if (one.known != other.known || one.least != other.least || one.largest != other.largest) {
    return false;
  }
  return std::ranges::all_of(scan.fresh, [&](std::uint32_t i) {
    const RayReading* const readings = ticks.readings.data() + i * ticks.rays;
    return are_same(readings[a].value, readings[b].value);
  });
}

bool spoke(const RayScan& ray, const TrialScan& scan, double share) {
  return static_cast<double>(ray.known) >= share * static_cast<double>(scan.fresh.size());
}

}  // namespace

std::vector<ValueFinding> check_rays(const Robot& robot,
                                     const CertificateParameters& parameters,
                                     const TickTable& ticks,
                                     const TrialScan& scan) {
  std::vector<ValueFinding> found;
  if (scan.fresh.size() < kLeastTicks || scan.last_way_m() < kLeastWayM) {
    return found;
  }
  const bool others_spoke = std::ranges::any_of(
      scan.rays, [&](const RayScan& ray) { return spoke(ray, scan, kSpokenShare); });
  std::size_t moving_until = 0;
  for (std::size_t k = 0; k < scan.rays.size(); ++k) {
    moving_until = std::max(moving_until, scan.rays[k].known > 0 ? same_since(ticks, scan, k) : 0);
  }
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < scan.rays.size(); ++k) {
    const Ray& ray = robot.rays[k];
    const RayScan& of = scan.rays[k];
    if (auto stuck = stuck_contact(ray, ticks, scan, k, parameters)) {
      found.push_back(std::move(*stuck));
    }
    if (others_spoke && !spoke(of, scan, kSilentShare)) {
      found.push_back(silent(ray, of, scan));
    }
    if (of.known == 0) {
      continue;
    }
    if (of.least == of.largest) {
      if (of.known >= kLeastTicks && (ray.kind == RayKind::bend || of.least < ray.reach_m)) {
        found.push_back(stuck_reading(ray, of, scan));
      }
      continue;
    }
    if (auto one = hung(ray, ticks, scan, k, moving_until)) {
      found.push_back(std::move(*one));
    }
    const auto same = std::ranges::find_if(
        moving, [&](std::size_t earlier) { return same_readings(ticks, scan, earlier, k); });
    if (same != moving.end()) {
      found.push_back(twin(ray, robot.rays[*same], scan));
    }
    moving.push_back(k);
  }
  return found;
}

}  // namespace tcert
