#include "datasets/check_rays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "datasets/tick_columns.hpp"
#include "datasets/travelled_way.hpp"

namespace tcert {
namespace {

constexpr std::size_t kLeastTicks = 50;
constexpr double kLeastWayM = 1.0;
// Grazing a wall at the end of its reach, a ray reads free as often as not, for up to a fifth of a
// trial's way; one that hangs does so for most of what is left.
constexpr double kLeastFreeShare = 0.5;  // of the readings since the contact began
constexpr double kLeastShareOfWay = 1.0 / 3.0;

/// A reading at a fresh tick.
struct Felt {
  double since_start_s = 0.0;
  double way_m = 0.0;
  RayReading reading;
};

using Column = std::vector<Felt>;

/// One column a ray.
std::vector<Column> fresh_columns(const TickTable& ticks) {
  const std::vector<double> way_m = travelled_way(ticks);
  std::vector<Column> columns(ticks.rays);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (ticks.stale[i] != 0) {
      continue;
    }
    const double since_s = 1e-9 * static_cast<double>(ticks.time_ns[i] - ticks.time_ns.front());
    for (std::size_t k = 0; k < ticks.rays; ++k) {
      columns[k].push_back({since_s, way_m[i], ticks.readings[i * ticks.rays + k]});
    }
  }
  return columns;
}

double clearance(const Ray& ray, double value) {
  return ray.kind == RayKind::bend ? calibrated_clearance(ray.calibration, value) : value;
}

/// Where the contact began that lasts to the end; the end if there is none.
Column::const_iterator last_contact(const Column& column, const CertificateParameters& parameters) {
  auto began = column.end();
  for (auto felt = column.begin(); felt != column.end(); ++felt) {
    const double force_n = felt->reading.fsr_n;
    if (began == column.end() && force_n >= parameters.contact_on_n) {
      began = felt;
    } else if (force_n < parameters.contact_off_n) {
      began = column.end();
    }
  }
  return began;
}

std::optional<table::Diagnostic> never_releases(const Ray& ray,
                                                const CertificateParameters& parameters,
                                                const Column& column) {
  const auto began = last_contact(column, parameters);
  const double free_m = longest_clearance(ray) - parameters.contact_slack_m;
  double known = 0.0;
  double free = 0.0;
  double free_way_m = 0.0;
  for (auto felt = began; felt != column.end(); ++felt) {
    known += std::isnan(felt->reading.value) ? 0.0 : 1.0;
    if (clearance(ray, felt->reading.value) >= free_m) {
      free += 1.0;
      free_way_m += felt == began ? 0.0 : felt->way_m - std::prev(felt)->way_m;
    }
  }
  if (free_way_m < std::max(kLeastWayM, kLeastShareOfWay * column.back().way_m) ||
      free < kLeastFreeShare * known) {
    return std::nullopt;
  }
  return table::Diagnostic{
      table::Severity::warning,
      "",
      0,
      force_column(ray),
      fmt::format("contact from {:.1f} s to the end at {:.1f} s",
                  began->since_start_s,
                  column.back().since_start_s),
      fmt::format("a contact that ends when its wall is gone: {:.0f} % of the readings since then "
                  "are free, over {:.1f} m of way; check the zero of the force sensor, raise "
                  "contact_off_n, or leave the column out",
                  100.0 * free / known,
                  free_way_m),
      1};
}

/// The one value of a ray that never moves. Missing readings are none.
std::optional<double> only_value(const Column& column) {
  std::optional<double> only;
  std::size_t count = 0;
  for (const Felt& felt : column) {
    const double value = felt.reading.value;
    if (std::isnan(value)) {
      continue;
    }
    if (value != only.value_or(value)) {
      return std::nullopt;
    }
    only = value;
    ++count;
  }
  return count >= kLeastTicks ? only : std::nullopt;
}

table::Diagnostic never_moves(const Ray& ray, double value, const Column& column) {
  return {table::Severity::warning,
          "",
          0,
          value_column(ray),
          fmt::format("{:g} at every tick", value),
          fmt::format("a reading that moves along {:.1f} m of way; a sensor that hangs or is not "
                      "plugged in reads so: leave the ray out, or the trial",
                      column.back().way_m),
          1};
}

bool same_values(const Column& a, const Column& b) {
  return std::ranges::equal(a, b, [](const Felt& x, const Felt& y) {
    return x.reading.value == y.reading.value ||
           (std::isnan(x.reading.value) && std::isnan(y.reading.value));
  });
}

table::Diagnostic identical(const Ray& ray, const Ray& earlier, const Column& column) {
  return {table::Severity::warning,
          "",
          0,
          value_column(ray),
          fmt::format("the {} readings of {}", column.size(), value_column(earlier)),
          "readings of its own: one sensor was logged under two names, or two names lead to one "
          "column; check 'columns' in bundle.json, or leave one ray out",
          1};
}

bool is_missing(const Column& column) {
  return std::ranges::all_of(column, [](const Felt& f) { return std::isnan(f.reading.value); });
}

}  // namespace

std::vector<table::Diagnostic> check_rays(const Robot& robot,
                                          const CertificateParameters& parameters,
                                          const TickTable& ticks,
                                          const std::string& file) {
  const std::vector<Column> columns = fresh_columns(ticks);
  std::vector<table::Diagnostic> found;
  if (columns.empty() || columns.front().size() < kLeastTicks ||
      columns.front().back().way_m < kLeastWayM) {
    return found;
  }
  std::vector<std::size_t> moving;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Ray& ray = robot.rays[k];
    if (auto warning = never_releases(ray, parameters, columns[k])) {
      found.push_back(std::move(*warning));
    }
    if (const auto value = only_value(columns[k])) {
      if (ray.kind == RayKind::bend || *value < ray.reach_m) {
        found.push_back(never_moves(ray, *value, columns[k]));
      }
    } else if (!is_missing(columns[k])) {
      const auto twin = std::ranges::find_if(
          moving, [&](std::size_t earlier) { return same_values(columns[earlier], columns[k]); });
      if (twin != moving.end()) {
        found.push_back(identical(ray, robot.rays[*twin], columns[k]));
      }
      moving.push_back(k);
    }
  }
  for (table::Diagnostic& warning : found) {
    warning.file = file;
  }
  return found;
}

}  // namespace tcert
