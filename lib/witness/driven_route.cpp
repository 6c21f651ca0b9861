#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <witness/driven_route.hpp>

namespace tcert::witness {
namespace {

constexpr double kSpacing = 0.05;  // m
constexpr double kJoin = 0.08;     // m

}  // namespace

DrivenPositions::Bin DrivenPositions::bin_of(Point p) noexcept {
  return {std::floor(p.x_m / kJoin), std::floor(p.y_m / kJoin)};
}

DrivenPositions::DrivenPositions(const Samples& samples) {
  bool breaks = true;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Point p = samples.poses[i].position;
    breaks = breaks || samples.breaks[i] != 0;
    if (points_.empty() || distance(points_.back(), p) > kSpacing || i + 1 == samples.size()) {
      bins_[bin_of(p)].push_back(points_.size());
      points_.push_back(p);
      broken_.push_back(breaks);
      breaks = false;
    }
  }
}

template <class Visit>
void DrivenPositions::for_each_step(std::size_t i, Visit visit) const {
  if (i > 0 && !broken_[i]) {
    visit(i - 1, distance(points_[i], points_[i - 1]));
  }
  if (i + 1 < points_.size() && !broken_[i + 1]) {
    visit(i + 1, distance(points_[i], points_[i + 1]));
  }
  const auto [bx, by] = bin_of(points_[i]);
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      const auto bin = bins_.find({bx + dx, by + dy});
      if (bin == bins_.end()) {
        continue;
      }
      for (const std::size_t j : bin->second) {
        const double step_m = distance(points_[i], points_[j]);
        if (step_m < kJoin) {
          visit(j, step_m);
        }
      }
    }
  }
}

std::vector<Point> DrivenPositions::route(const Region& start,
                                          const Region& goal,
                                          double most_m) const {
  std::vector<double> way_m(points_.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> from(points_.size(), points_.size());
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto lower = [&](std::size_t i, std::size_t before, double value) {
    if (value < way_m[i] && value <= most_m) {
      way_m[i] = value;
      from[i] = before;
      queue.emplace(value, i);
    }
  };
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (contains(start, points_[i])) {
      lower(i, points_.size(), 0.0);
    }
  }
  while (!queue.empty()) {
    const auto [value, i] = queue.top();
    queue.pop();
    if (value > way_m[i]) {
      continue;
    }
    if (contains(goal, points_[i])) {
      std::vector<Point> route;
      for (std::size_t k = i; k < points_.size(); k = from[k]) {
        route.push_back(points_[k]);
      }
      std::reverse(route.begin(), route.end());
      return route;
    }
    for_each_step(i, [&, at = i, way = value](std::size_t next, double step_m) {
      lower(next, at, way + step_m);
    });
  }
  return {};
}

}  // namespace tcert::witness
