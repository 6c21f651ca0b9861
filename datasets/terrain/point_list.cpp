#include "datasets/terrain/point_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace tcert::terrain_reading {
namespace {

constexpr std::size_t kColumns = 3;
constexpr double kOffNode = 0.1;          // of a step
constexpr double kSameCoordinate = 1e-6;  // of the range
constexpr double kLeastFilled = 0.25;
constexpr double kPointsPerLine = 1.5;
constexpr double kMostTwice = 0.1;  // of the points
constexpr double kApart = 3.0;      // times the widest span
/// So many lines of three are points sooner than a terrain three cells wide.
constexpr std::size_t kMostRowsOfAStrip = 16;

constexpr std::string_view kWayOut =
    "; put points on a lattice first (gdal_grid), or, if this is a terrain three cells wide, give "
    "--terrain-format grid";

struct Axis {
  double low = 0.0;
  double step = 0.0;
  int count = 0;
  std::size_t distinct = 0;

  [[nodiscard]] int node(double v) const noexcept {
    return static_cast<int>(std::lround((v - low) / step));
  }
};

[[nodiscard]] std::vector<double> column_of(std::span<const double> values, std::size_t column) {
  std::vector<double> out;
  for (std::size_t i = column; i < values.size(); i += kColumns) {
    out.push_back(values[i]);
  }
  return out;
}

[[nodiscard]] std::optional<Axis> axis_of(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  const double range = v.back() - v.front();
  if (!std::isfinite(range) || !(range > 0.0)) {
    return std::nullopt;
  }
  Axis axis;
  axis.low = v.front();
  axis.distinct = 1;
  double step = range;
  for (std::size_t i = 1; i < v.size(); ++i) {
    const double d = v[i] - v[i - 1];
    if (d > kSameCoordinate * range) {
      step = std::min(step, d);
      ++axis.distinct;
    }
  }
  // Each distance counts its own steps, so that coordinates that were rounded do not add up.
  double lines = 0.0;
  for (std::size_t i = 1; i < v.size(); ++i) {
    const double d = v[i] - v[i - 1];
    lines += d > kSameCoordinate * range ? std::round(d / step) : 0.0;
  }
  if (lines > kMostTerrainSide - 1) {
    return std::nullopt;
  }
  axis.count = static_cast<int>(lines) + 1;
  axis.step = range / lines;
  const bool even = std::all_of(v.begin(), v.end(), [&](double x) {
    const double at = (x - axis.low) / axis.step;
    return std::abs(at - std::round(at)) <= kOffNode;
  });
  return even ? std::optional(axis) : std::nullopt;
}

struct Nodes {
  std::vector<double> values;  ///< NaN where there is no point.
  std::size_t filled = 0;
  std::size_t repeated = 0;     ///< Points that say again what their node holds.
  std::size_t twice = 0;        ///< Points that say another value.
  std::size_t first_twice = 0;  ///< Index of the first point whose node was taken.
};

[[nodiscard]] Nodes fill(std::span<const double> values, const Axis& x, const Axis& y) {
  Nodes nodes;
  const auto width = static_cast<std::size_t>(y.count);
  const std::size_t size = static_cast<std::size_t>(x.count) * width;
  nodes.values.assign(size, std::numeric_limits<double>::quiet_NaN());
  std::vector<bool> taken(size, false);
  for (std::size_t i = 0; i < values.size(); i += kColumns) {
    const std::size_t at = static_cast<std::size_t>(x.node(values[i])) * width +
                           static_cast<std::size_t>(y.node(values[i + 1]));
    const double value = values[i + 2];
    if (taken[at] && (nodes.values[at] == value || std::isnan(value))) {
      ++nodes.repeated;
      continue;
    }
    if (taken[at] && !std::isnan(nodes.values[at])) {
      nodes.first_twice = nodes.twice == 0 ? i / kColumns : nodes.first_twice;
      ++nodes.twice;
      continue;
    }
    nodes.filled += taken[at] ? 0U : 1U;
    taken[at] = true;
    nodes.values[at] = value;
  }
  return nodes;
}

/// The ranges of the first two columns, and of the third, lie far from one another.
[[nodiscard]] bool columns_lie_apart(std::span<const double> values) {
  std::array<std::pair<double, double>, kColumns> ranges{};
  double widest = 0.0;
  for (std::size_t k = 0; k < kColumns; ++k) {
    const std::vector<double> column = column_of(values, k);
    const auto [low, high] = std::minmax_element(column.begin(), column.end());
    ranges[k] = {*low, *high};
    widest = std::max(widest, *high - *low);
  }
  std::sort(ranges.begin(), ranges.end());
  bool apart = widest > 0.0;
  for (std::size_t k = 1; k < kColumns; ++k) {
    apart = apart && ranges[k].first - ranges[k - 1].second > kApart * widest;
  }
  return apart;
}

[[nodiscard]] bool all_places_differ(std::span<const double> values) {
  std::vector<std::pair<double, double>> places;
  for (std::size_t i = 0; i < values.size(); i += kColumns) {
    places.emplace_back(values[i], values[i + 1]);
  }
  std::sort(places.begin(), places.end());
  return std::adjacent_find(places.begin(), places.end()) == places.end();
}

[[nodiscard]] std::string note_of(const Axis& x, const Axis& y, std::size_t points) {
  std::string text = fmt::format(
      "{} points x, y, value on a lattice of {} x {} cells: cell x is (x - {:.10g}) / {:.6g}, cell "
      "y is (y - {:.10g}) / {:.6g}, both from 0 upwards",
      points,
      x.count,
      y.count,
      x.low,
      x.step,
      y.low,
      y.step);
  if (std::abs(x.step - y.step) > 1e-3 * x.step) {
    return text + "; the cells are not square, and all lengths are in cells";
  }
  return text + fmt::format(
                    "; lengths, --lipschitz and length scales stay per cell (a slope of s "
                    "per unit is L = {:.4g} s) unless --units metres says otherwise; "
                    "--terrain-format grid reads a terrain "
                    "three cells wide",
                    x.step);
}

[[nodiscard]] PointListResult broken(std::string problem) {
  PointListResult result;
  result.kind = PointList::broken;
  result.problem = std::move(problem) + std::string(kWayOut);
  return result;
}

/// Whether so many points may fill the nodes of two axes.
[[nodiscard]] bool is_dense(const std::optional<Axis>& x,
                            const std::optional<Axis>& y,
                            std::size_t points) {
  return x && y && x->distinct > 1 && y->distinct > 1 &&
         static_cast<double>(x->count) * y->count <= static_cast<double>(points) / kLeastFilled;
}

/// Points whose coordinates lie on the nodes of two axes; `none` if that may be chance.
[[nodiscard]] PointListResult on_nodes(std::span<const double> values,
                                       const Axis& x,
                                       const Axis& y,
                                       bool wanted) {
  const std::size_t points = values.size() / kColumns;
  Nodes nodes = fill(values, x, y);
  const auto longer = static_cast<double>(std::max(x.distinct, y.distinct));
  const bool full = static_cast<double>(nodes.filled) >= kPointsPerLine * longer;
  const bool few_twice =
      static_cast<double>(nodes.twice + nodes.repeated) <= kMostTwice * static_cast<double>(points);
  if (!wanted && !(full && few_twice)) {
    return {};
  }
  if (nodes.twice > 0) {
    return broken(
        fmt::format("one value at every point x, y, but the point number {} stands where another "
                    "does, with another value",
                    nodes.first_twice + 1));
  }
  if (!full) {
    return broken("points on a lattice, but too few of its nodes are there");
  }
  PointListResult result;
  result.kind = PointList::lattice;
  result.terrain = {x.count, y.count, std::move(nodes.values), {}};
  result.terrain.frame = {x.low, y.low, false, x.step, y.step, true};
  result.note = note_of(x, y, points);
  return result;
}

/// What is expected of points that there are too few of, or that have no place; or nothing.
[[nodiscard]] std::string_view lack_of(std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); i += kColumns) {
    if (!std::isfinite(values[i]) || !std::isfinite(values[i + 1])) {
      return "two coordinates of every point";
    }
  }
  return values.size() < 4 * kColumns ? "four points x, y, value or more" : "";
}

}  // namespace

PointListResult read_points(std::span<const double> values, bool wanted) {
  if (const std::string_view lack = lack_of(values); !lack.empty()) {
    return wanted ? broken(std::string(lack)) : PointListResult{};
  }
  const std::size_t points = values.size() / kColumns;
  const auto x = axis_of(column_of(values, 0));
  const auto y = axis_of(column_of(values, 1));
  if (is_dense(x, y, points)) {
    PointListResult result = on_nodes(values, *x, *y, wanted);
    if (result.kind != PointList::none) {
      return result;
    }
  }
  if (wanted) {
    return broken("points x, y, value whose x and y are evenly spaced");
  }
  if (all_places_differ(values) && (points >= kMostRowsOfAStrip || columns_lie_apart(values))) {
    return broken(
        "a terrain, but these three columns look like points x, y, value that form no lattice");
  }
  return {};
}

bool names_coordinates(std::string_view first, std::string_view second) {
  const auto is_one_of = [](std::string_view name, std::span<const std::string_view> words) {
    std::string lower;
    for (const char c : name) {
      if (c != '"' && c != '\'') {
        lower += static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
      }
    }
    const std::string bare = lower.substr(0, lower.find_first_of("_ [("));
    return std::find(words.begin(), words.end(), bare) != words.end();
  };
  constexpr std::array<std::string_view, 8> kFirst{
      "x", "lon", "long", "longitude", "easting", "east", "e", "utmx"};
  constexpr std::array<std::string_view, 7> kSecond{
      "y", "lat", "latitude", "northing", "north", "n", "utmy"};
  return (is_one_of(first, kFirst) && is_one_of(second, kSecond)) ||
         (is_one_of(first, kSecond) && is_one_of(second, kFirst));
}

}  // namespace tcert::terrain_reading
