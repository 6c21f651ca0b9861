#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <witness/bisected_band.hpp>
#include <witness/lane_bands.hpp>
#include <witness/polygon.hpp>
#include <witness/waypoint.hpp>

namespace tcert::witness {
namespace {

constexpr double kCoarse = 0.08;   // m, between the points of a lane's band; halved once
constexpr double kSpacing = 0.04;  // m, between those of a band with held ends; halved once
constexpr double kFewest = 6.0;    // pieces of such a band
constexpr std::size_t kHeld = 2;
constexpr int kLevels = 2;
constexpr int kMostSteps = 600;      // along a lane
constexpr double kLeftOfEnds = 0.3;  // of its first and last edge, that the band may leave out
constexpr double kLeast = 1e-6;      // m

double length_of(const std::vector<Point>& way) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length_m += distance(way[i - 1], way[i]);
  }
  return length_m;
}

/// A place of a polygon: a share of the way from point `before` to the next.
struct Place {
  std::size_t before = 0;
  double share = 0.0;
};

Point at(const std::vector<Point>& polygon, Place place) {
  const Point from = polygon[place.before];
  return from + place.share * (polygon[place.before + 1] - from);
}

/// Where the polygon crosses the line through `node` along `heading`, beyond `from`: the nearest to
/// the node, within the radius.
std::optional<Place> crossing(
    const std::vector<Point>& polygon, Place from, Point node, Point heading, double radius_m) {
  std::optional<Place> nearest;
  for (std::size_t i = from.before; i + 1 < polygon.size(); ++i) {
    const double before_m = dot(polygon[i] - node, heading);
    const double after_m = dot(polygon[i + 1] - node, heading);
    if (before_m > 0.0 || after_m <= 0.0) {
      continue;
    }
    const Place place{i, before_m / (before_m - after_m)};
    const double off_m = distance(node, at(polygon, place));
    if ((i > from.before || place.share > from.share) && off_m <= radius_m) {
      radius_m = off_m;
      nearest = place;
    }
  }
  return nearest;
}

/// The polygon, stretched coarse and fine.
std::vector<Point> stretched_twice(std::vector<Point> polygon,
                                   double most_m,
                                   const BandProblem& problem,
                                   int steps) {
  Band band{std::move(polygon), 0.0};
  for (int level = 0; level < kLevels; ++level) {
    if (level > 0) {
      band.polygon = refined(band.polygon);
    }
    band.margin_m = estimate(band.polygon, problem.field, problem.robot).margin_m;
    int budget = steps / kLevels;
    band = bisected(std::move(band), {most_m, most_m}, problem, budget);
  }
  return std::move(band.polygon);
}

}  // namespace

std::vector<Point> polygon_between(const Pose& from, const Pose& to, std::vector<Point> way) {
  const Point at_begin = from.position - way.front();
  const Point at_end = to.position - way.back();
  const double length_m = std::max(kLeast, length_of(way));
  double done_m = 0.0;
  Point before = way.front();
  for (Point& p : way) {
    done_m += distance(before, p);
    before = p;
    p = p + at_begin + (done_m / length_m) * (at_end - at_begin);
  }
  way.front() = from.position;
  way.back() = to.position;
  std::vector<Point> polygon = resampled(way, std::min(kSpacing, length_of(way) / kFewest));
  const double spacing_m = distance(polygon[0], polygon[1]);
  polygon[1] = from.position + spacing_m * direction(from.yaw_rad);
  polygon[polygon.size() - 2] = to.position - spacing_m * direction(to.yaw_rad);
  return smoothed(std::move(polygon), kHeld);
}

LaneBands::LaneBands(const EdgeProblem& problem, double merge_radius_m, int steps, EdgeWays& ways)
    : problem_(problem),
      merge_radius_m_(merge_radius_m),
      steps_(steps),
      found_(ways),
      is_crossed_(problem.nodes.size(), false) {}

void LaneBands::stretch_lane(std::span<const EdgeStep> lane) {
  const std::span<const Edge> edges = problem_.edges;
  const std::vector<Point> way = joined(lane);
  if (length_of(way) < kLeast) {
    return;
  }
  const EdgeEnd& begin = begin_of(edges, lane.front());
  const EdgeEnd& end = end_of(edges, lane.back());
  double most_m = most_across(end.node);
  for (const EdgeStep step : lane) {
    most_m = std::min(most_m, most_across(begin_of(edges, step).node));
  }
  const Region start = end_region(begin.node, lane.front());
  const Region goal = end_region(end.node, lane.back());
  const int fours = static_cast<int>(std::min<std::size_t>(lane.size() / 4 + 1, kMostSteps));
  const std::vector<Point> p =
      stretched_twice(smoothed(resampled(way, kCoarse)),
                      most_m,
                      {problem_.space.field, start, goal, problem_.robot},
                      std::min(kMostSteps, fours * std::min(steps_, kMostSteps)));
  if (const std::size_t i = take(lane, p); i > 0) {
    stretch_lane(lane.first(i));
    stretch_lane(lane.subspan(i));
    return;
  }
  end_at(begin, p.front(), p[0] - p[1]);
  end_at(end, p.back(), p.back() - p[p.size() - 2]);
}

void LaneBands::stretch_between(std::span<const EdgeStep> steps) {
  const EdgeEnd& begin = begin_of(problem_.edges, steps.front());
  const EdgeEnd& end = end_of(problem_.edges, steps.back());
  Pose from = found_.waypoints[begin.node];
  Pose to = found_.waypoints[end.node];
  from.yaw_rad = heading_of_leaving(from, begin.side);
  to.yaw_rad = heading_of_entering(to, end.side);
  if (distance(from.position, to.position) < kLeast) {
    return;
  }
  // No path between two places is wider than those are.
  const DistanceField& field = problem_.space.field;
  double most_m = 2.0 * (std::min(field.at(from.position), field.at(to.position)) -
                         needed_clearance(problem_.robot, 0.0));
  for (const EdgeStep step : steps.subspan(1)) {
    most_m = std::min(most_m, most_across(begin_of(problem_.edges, step).node));
  }
  take(steps,
       stretched_twice(polygon_between(from, to, joined(steps)),
                       most_m,
                       {field, problem_.start, problem_.goal, problem_.robot, kHeld},
                       steps_));
}

std::vector<Point> LaneBands::joined(std::span<const EdgeStep> steps) const {
  std::vector<Point> way;
  for (const EdgeStep step : steps) {
    std::vector<Point> next = found_.ways[step.edge];
    if (step.is_reversed) {
      std::reverse(next.begin(), next.end());
    }
    way.insert(way.end(), next.begin() + (way.empty() ? 0 : 1), next.end());
  }
  return way;
}

// In S, in G, or so near to its node that the edge keeps most of its length.
Region LaneBands::end_region(std::uint32_t node, EdgeStep step) const {
  const Point position = problem_.nodes[node].pose.position;
  for (const Region* region : {&problem_.start, &problem_.goal}) {
    if (contains(*region, position)) {
      return *region;
    }
  }
  const auto place = [&](const EdgeEnd& end) { return problem_.nodes[end.node].pose.position; };
  const double edge_m =
      distance(place(begin_of(problem_.edges, step)), place(end_of(problem_.edges, step)));
  return Disc{position, std::min(merge_radius_m_, kLeftOfEnds * edge_m)};
}

// The most that a path can have of margin that crosses the node's line within the merge radius.
double LaneBands::most_across(std::uint32_t node) const {
  const DistanceField& field = problem_.space.field;
  const Node& crossed = problem_.nodes[node];
  const Point at_node = crossed.pose.position;
  const Point side{-crossed.heading.y_m, crossed.heading.x_m};
  const double step_m = std::max(field.cell_m(), 1e-2 * merge_radius_m_);
  double most_m = field.at(at_node);
  const int steps = static_cast<int>(merge_radius_m_ / step_m);
  for (int i = 1; i <= steps; ++i) {
    const double off_m = i * step_m;
    most_m = std::max({most_m, field.at(at_node + off_m * side), field.at(at_node - off_m * side)});
  }
  return 2.0 * (most_m - needed_clearance(problem_.robot, 0.0));
}

// Cuts the polygon at the nodes' lines into the ways of the steps, with waypoints there. If it
// crosses one too far from its node nothing is changed, and the step that begins there handed back.
std::size_t LaneBands::take(std::span<const EdgeStep> steps, const std::vector<Point>& polygon) {
  std::vector<Place> cuts{{0, 0.0}};
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const EdgeEnd& left = begin_of(problem_.edges, steps[i]);
    const Node& node = problem_.nodes[left.node];
    const Point heading = left.side == Side::front ? node.heading : -1.0 * node.heading;
    const auto place = crossing(polygon, cuts.back(), node.pose.position, heading, merge_radius_m_);
    if (!place) {
      return i;
    }
    cuts.push_back(*place);
  }
  cuts.push_back({polygon.size() - 2, 1.0});
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const auto point = [&](std::size_t k) {
      return std::next(polygon.begin(), static_cast<std::ptrdiff_t>(k + 1));
    };
    std::vector<Point> way{at(polygon, cuts[i])};
    way.insert(way.end(), point(cuts[i].before), point(cuts[i + 1].before));
    way.push_back(at(polygon, cuts[i + 1]));
    if (steps[i].is_reversed) {
      std::reverse(way.begin(), way.end());
    }
    found_.ways[steps[i].edge] = std::move(way);
    if (i > 0) {
      const Point along = polygon[cuts[i].before + 1] - polygon[cuts[i].before];
      const EdgeEnd& left = begin_of(problem_.edges, steps[i]);
      const Point ahead = left.side == Side::front ? along : -1.0 * along;
      found_.waypoints[left.node] = {at(polygon, cuts[i]), elementary::atan2(ahead.y_m, ahead.x_m)};
      is_crossed_[left.node] = true;
    }
  }
  return 0;
}

// `outward` leads on beyond the end of a lane.
void LaneBands::end_at(const EdgeEnd& end, Point position, Point outward) {
  const Node& node = problem_.nodes[end.node];
  if (!is_crossed_[end.node] &&
      is_near(position, node, problem_.start, problem_.goal, merge_radius_m_)) {
    const Point ahead = end.side == Side::back ? outward : -1.0 * outward;
    found_.waypoints[end.node] = {position, elementary::atan2(ahead.y_m, ahead.x_m)};
  }
}

}  // namespace tcert::witness
