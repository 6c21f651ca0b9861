#include "datasets/range_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "datasets/ray_names.hpp"
#include "datasets/tick_columns.hpp"

namespace tcert {
namespace {

constexpr double kLargestShare = 0.05;
constexpr double kLargeShare = 0.2;
constexpr double kAlone = 0.8;   // all other readings lie below this share of it
constexpr double kWhole = 0.01;  // single precision keeps as much of a count of 16 bits

double share_of(std::size_t count, const RangeCount& of) {
  return of.stated > 0 ? static_cast<double>(count) / static_cast<double>(of.stated) : 0.0;
}

/// Rays of which the same is to be said.
struct Rays {
  std::vector<std::string> columns;
  std::size_t readings = 0;
  double largest_share = 0.0;
  double value = 0.0;  // that of the largest share
  double lowest = 0.0;

  void add(const Ray& ray, std::size_t count, double repeated, const RangeCount& of) {
    columns.push_back(value_column(ray));
    readings += count;
    if (share_of(count, of) > largest_share) {
      largest_share = share_of(count, of);
      value = repeated;
    }
    lowest = std::min(lowest, of.lowest);
  }
};

/// 65.535, 8.191, 8.183: the largest numbers of 12 bits and more, in mm or cm, of which sensors
/// keep the last few for what is no distance; 9.999 and the like.
bool is_code_of_a_sensor(double value) noexcept {
  constexpr double kKeptForCodes = 10.0;
  for (const double per_metre : {1000.0, 100.0}) {
    const double count = value * per_metre;
    for (int bits = 12; bits <= 16; ++bits) {
      const double below = std::ldexp(1.0, bits) - count;
      if (below > 0.0 && below <= kKeptForCodes && std::abs(count - std::round(count)) < kWhole) {
        return true;
      }
    }
    for (const double nines : {9999.0, 99999.0, 999999.0}) {
      if (std::abs(count - nines) < kWhole) {
        return true;
      }
    }
  }
  return false;
}

/// The largest reading of a ray, if it may stand for something else.
std::optional<double> suspicious_highest(const Ray& ray, const RangeCount& of) {
  const double share = share_of(of.at_highest, of);
  const bool is_all = of.at_highest == of.undeclared;
  const bool alone = of.below_highest < kAlone * of.highest;
  const bool beyond = of.highest > ray.reach_m;
  const bool suspicious =
      is_code_of_a_sensor(of.highest) || (beyond && (alone || share > kLargeShare));
  if (of.highest <= 0.0 || of.highest == ray.reach_m || is_all || share <= kLargestShare ||
      !suspicious) {
    return std::nullopt;
  }
  return of.highest;
}

class Report {
 public:
  explicit Report(std::string file) : file_(std::move(file)) {}

  void add(table::Severity severity, const Rays& rays, std::string value, std::string expectation) {
    if (!rays.columns.empty()) {
      lines_.push_back({severity,
                        file_,
                        0,
                        joined_names(rays.columns),
                        std::move(value),
                        std::move(expectation),
                        1});
    }
  }

  [[nodiscard]] std::vector<table::Diagnostic> take() { return std::move(lines_); }

 private:
  std::string file_;
  std::vector<table::Diagnostic> lines_;
};

std::string repeated(const Rays& rays) {
  return fmt::format("{:g} in {:.0f} % of the readings", rays.value, 100.0 * rays.largest_share);
}

std::string way_out(const Rays& rays, const char* read_as, const char* limit) {
  return fmt::format(
      "distances; it is read as {}. If it means nothing within reach, say so by "
      "'no_return': [{:g}] of the ray in bundle.json, if no reading, by '{}'",
      read_as,
      rays.value,
      limit);
}

}  // namespace

std::vector<table::Diagnostic> range_report(const Robot& robot,
                                            std::span<const RangeCount> counts,
                                            const std::string& file) {
  Rays negative;
  Rays zero;
  Rays beyond;
  Rays within;
  Rays below_min;
  Rays above_max;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const Ray& ray = robot.rays[k];
    const RangeCount& of = counts[k];
    const auto take = [&](std::size_t count, Rays& rays, double value = 0.0) {
      if (count > 0) {
        rays.add(ray, count, value, of);
      }
    };
    take(of.negative, negative);
    take(share_of(of.zero, of) > kLargestShare ? of.zero : 0, zero);
    take(of.below_min, below_min);
    take(of.above_max, above_max);
    if (const auto value = suspicious_highest(ray, of)) {
      take(of.at_highest, *value > ray.reach_m ? beyond : within, *value);
    }
  }
  using enum table::Severity;
  Report report(file);
  report.add(warning,
             negative,
             fmt::format("{} readings below 0, down to {:g}", negative.readings, negative.lowest),
             "distances; these are missing. If they mean nothing within reach, say so by "
             "'no_return' of the ray in bundle.json");
  report.add(warning, zero, repeated(zero), way_out(zero, "a wall at the sensor", "range_min_m"));
  report.add(
      warning, beyond, repeated(beyond), way_out(beyond, "free to the reach", "range_max_m"));
  report.add(warning, within, repeated(within), way_out(within, "a wall there", "range_max_m"));
  report.add(note,
             below_min,
             fmt::format("{} readings below range_min_m", below_min.readings),
             "distances that the sensor can tell; these are missing");
  report.add(note,
             above_max,
             fmt::format("{} readings above range_max_m", above_max.readings),
             "distances that the sensor can tell; these are missing");
  return report.take();
}

}  // namespace tcert
