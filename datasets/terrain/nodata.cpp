#include "datasets/terrain/nodata.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <table/not_a_number.hpp>

namespace tcert::terrain_reading {
namespace {

/// What GDAL, ArcGIS and their kin write where nothing was measured.
constexpr std::array kSentinels{-9999.0,
                                -32768.0,
                                -32767.0,
                                32767.0,
                                65535.0,
                                -999.0,
                                -99999.0,
                                -999999.0,
                                -9999999.0,
                                -9999.9,
                                9999.0,
                                99999.0,
                                999999.0,
                                -1e20,
                                1e20,
                                -2147483648.0,
                                -2147483647.0,
                                2147483647.0,
                                4294967295.0};

/// A sentinel lies outside of all other values by this share of their range.
constexpr double kOutside = 0.5;
/// Another repeated value so far out, in ranges, is at least worth a question.
constexpr double kFarOutside = 10.0;

[[nodiscard]] bool is_sentinel(double v) {
  return std::find(kSentinels.begin(), kSentinels.end(), v) != kSentinels.end();
}

/// Equal, or equal once rounded to single precision, as rasters hold them.
[[nodiscard]] bool same(double a, double b) noexcept {
  return a == b || (std::abs(a) < 1e38 && std::abs(b) < 1e38 &&
                    static_cast<float>(a) == static_cast<float>(b));
}

struct Extreme {
  double value = 0.0;
  std::size_t count = 0;
  double outside = 0.0;  ///< From the nearest of the others.
  double range = 0.0;    ///< Of the others.
  bool alone = true;     ///< There are no others.
};

/// The lowest value and how it lies to the others, or with `sign` -1 the highest.
[[nodiscard]] Extreme extreme_of(std::span<const double> values, double sign) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double lowest = kInfinity;
  for (const double v : values) {
    if (!std::isnan(v)) {
      lowest = std::min(lowest, sign * v);
    }
  }
  Extreme extreme;
  extreme.value = sign * lowest;
  double low = kInfinity;
  double high = -kInfinity;
  for (const double v : values) {
    if (std::isnan(v)) {
      continue;
    }
    if (sign * v == lowest) {
      ++extreme.count;
    } else {
      low = std::min(low, sign * v);
      high = std::max(high, sign * v);
    }
  }
  extreme.alone = high < low;
  extreme.outside = extreme.alone ? 0.0 : low - lowest;
  extreme.range = extreme.alone ? 0.0 : high - low;
  return extreme;
}

class Marker {
 public:
  explicit Marker(std::span<double> values) : values_(values) {
    words_ = static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }));
    if (words_ > 0) {
      add("without a number", words_);
    }
  }

  template <class Is>
  std::size_t mark(Is is) {
    std::size_t count = 0;
    for (double& v : values_) {
      if (!std::isnan(v) && is(v)) {
        v = table::kNaN;
        ++count;
      }
    }
    return count;
  }

  void declared(double value) {
    const std::size_t count = mark([&](double v) { return same(v, value); });
    if (count > 0) {
      add(fmt::format("of the nodata value {:.9g}", value), count);
    }
  }

  void beyond() {
    double first = 0.0;
    const std::size_t count = mark([&](double v) {
      const bool far = std::abs(v) > kLargestTerrainValue;
      first = far && first == 0.0 ? v : first;
      return far;
    });
    if (count > 0) {
      add(fmt::format("of {:.6g}", first), count);
    }
  }

  void recognised(std::vector<std::string>& notes) {
    // One that goes may leave another at the other end as far outside as it should be.
    while (mark_sentinel(1.0) || mark_sentinel(-1.0)) {
      guessed_ = true;
    }
    for (const double sign : {1.0, -1.0}) {
      ask(extreme_of(values_, sign), notes);
    }
  }

  [[nodiscard]] GapsResult finish() {
    GapsResult result;
    result.gaps = gaps_;
    if (gaps_ > 0) {
      result.notes.push_back(fmt::format(
          "{} of {} cells are gaps ({}): nothing is known there, and nobody measures or goes "
          "there{}",
          gaps_,
          values_.size(),
          kinds_,
          guessed_ ? "; --nodata none reads them as values" : ""));
    }
    if (gaps_ == values_.size()) {
      result.problem = "a cell with a value, but all are gaps";
    }
    for (const double v : values_) {
      if (std::abs(v) > kLargestTerrainValue) {
        result.problem = fmt::format(
            "values of at most {:g} either way, but there is {:g}; leave out --nodata none if that "
            "means that nothing is known",
            kLargestTerrainValue,
            v);
      }
    }
    return result;
  }

 private:
  /// Makes gaps of the lowest value, or with `sign` -1 of the highest, if it is a sentinel.
  bool mark_sentinel(double sign) {
    const Extreme e = extreme_of(values_, sign);
    if (e.alone || !is_sentinel(e.value) || e.outside < kOutside * e.range) {
      return false;
    }
    add(fmt::format("of {:.9g}", e.value), mark([&](double v) { return v == e.value; }));
    return true;
  }

  void add(const std::string& kind, std::size_t count) {
    gaps_ += count;
    kinds_ += fmt::format("{}{} {}", kinds_.empty() ? "" : ", ", count, kind);
  }

  static void ask(const Extreme& e, std::vector<std::string>& notes) {
    const bool odd = !e.alone && e.range > 0.0 &&
                     (is_sentinel(e.value) || (e.count > 1 && e.outside > kFarOutside * e.range));
    if (odd) {
      notes.push_back(fmt::format(
          "warning: {0} {3} {1:.9g}, {2:.4g} from the nearest other value; if that means that "
          "nothing is known, give --nodata {1:.9g}, else --nodata none",
          e.count,
          e.value,
          e.outside,
          e.count == 1 ? "cell holds" : "cells hold"));
    }
  }

  std::span<double> values_;
  std::string kinds_;
  std::size_t words_ = 0;
  std::size_t gaps_ = 0;
  bool guessed_ = false;
};

}  // namespace

GapsResult mark_gaps(std::span<double> values,
                     const NodataRule& rule,
                     std::optional<double> declared) {
  std::vector<std::string> notes;
  Marker marker(values);
  const std::optional<double> nodata = rule.declared ? rule.declared : declared;
  if (nodata && (rule.declared || rule.recognise)) {
    marker.declared(*nodata);
  }
  if (rule.declared || rule.recognise) {
    marker.beyond();
  }
  if (rule.recognise && !rule.declared) {
    marker.recognised(notes);
  }
  GapsResult result = marker.finish();
  result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  return result;
}

}  // namespace tcert::terrain_reading
