#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <witness/driven_route.hpp>

namespace tcert::witness {
namespace {

constexpr double kSpacing = 0.05;  // m
constexpr double kJoin = 0.08;     // m

using Bin = std::pair<double, double>;

Bin bin_of(Point p) noexcept { return {std::floor(p.x_m / kJoin), std::floor(p.y_m / kJoin)}; }

}  // namespace

std::vector<Point> driven_route(const Samples& samples, const Region& start, const Region& goal) {
  std::vector<Point> points;
  std::vector<bool> broken;
  std::map<Bin, std::vector<std::size_t>> bins;
  bool breaks = true;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Point p = samples.poses[i].position;
    breaks = breaks || samples.breaks[i] != 0;
    if (points.empty() || distance(points.back(), p) > kSpacing || i + 1 == samples.size()) {
      bins[bin_of(p)].push_back(points.size());
      points.push_back(p);
      broken.push_back(breaks);
      breaks = false;
    }
  }
  std::vector<double> way_m(points.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(points.size(), points.size());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto lower = [&](std::size_t i, std::size_t before, double value) {
    if (value < way_m[i]) {
      way_m[i] = value;
      from[i] = before;
      queue.emplace(value, i);
    }
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (contains(start, points[i])) {
      lower(i, points.size(), 0.0);
    }
  }
  while (!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if (value > way_m[i]) {
      continue;
    }
    if (contains(goal, points[i])) {
      std::vector<Point> route;
      for (std::size_t k = i; k < points.size(); k = from[k]) {
        route.push_back(points[k]);
      }
      std::reverse(route.begin(), route.end());
      return route;
    }
    if (i > 0 && !broken[i]) {
      lower(i - 1, i, value + distance(points[i], points[i - 1]));
    }
    if (i + 1 < points.size() && !broken[i + 1]) {
      lower(i + 1, i, value + distance(points[i], points[i + 1]));
    }
    const auto [bx, by] = bin_of(points[i]);
    for (double dx = -1.0; dx <= 1.0; ++dx) {
      for (double dy = -1.0; dy <= 1.0; ++dy) {
        const auto bin = bins.find({bx + dx, by + dy});
        if (bin == bins.end()) {
          continue;
        }
        for (const std::size_t j : bin->second) {
          const double step_m = distance(points[i], points[j]);
          if (step_m < kJoin) {
            lower(j, i, value + step_m);
          }
        }
      }
    }
  }
  return {};
}

}  // namespace tcert::witness
