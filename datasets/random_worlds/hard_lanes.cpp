#include <algorithm>
#include <cmath>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/families.hpp"
#include "datasets/random_worlds/sided_lane.hpp"
#include "datasets/random_worlds/walled_lane.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

constexpr double kFirst = 0.85;  // of the first feature from S's middle, of the last from G's

}  // namespace

// S and G are small discs just before the lane's ends; a third of them lie in a pocket or behind a
// gate, and a quarter of the runs are driven backwards. W has to begin with its clearance in S, so
// that the way from the cap behind S to the front of S limits it, too.
RandomWorld draw_tight_ends(table::RandomStream& random) {
  SidedLane lane = walled_lane(random.uniform(3.0, 4.0), random.uniform(0.85, 1.3));
  const auto end = [&] {
    return Disc{{random.uniform(0.23, 0.45), 0.0}, random.uniform(0.04, 0.15)};
  };
  lane.start = end();
  lane.goal = end();
  const double to_start = lane.start.centre.x_m + lane.start.radius_m;  // from the cap to its front
  const double to_goal = lane.goal.centre.x_m + lane.goal.radius_m;
  lane.goal.centre.x_m = lane.length_m - lane.goal.centre.x_m;
  const auto gate = [&](double edge, double cap, double ahead) {
    const double from = random.below(2) == 0 ? cap : edge + ahead * random.uniform(0.005, 0.25);
    const double to = (from == cap ? edge : from) + ahead * random.uniform(0.10, 0.20);
    const double least = from == cap ? corpus_robot().body_width_m + 0.006 : 0.0;
    const double width = std::max(std::min(draw_gate_width(random), lane.width_m - 0.1), least);
    const double aside = from == cap ? 0.0 : random.uniform(-0.04, 0.04);
    add_gate(lane, {{0.5 * (from + to), aside}, 0.0}, width, std::abs(to - from));
  };
  if (random.below(3) == 0) {
    gate(to_start, 0.0, 1.0);
  }
  if (random.below(3) == 0) {
    gate(lane.length_m - to_goal, lane.length_m, -1.0);
  }
  // A gate's middle may lie behind S or beyond G, where the run does not go.
  std::erase_if(lane.way, [&](const Pose& pose) {
    return pose.position.x_m < to_start || pose.position.x_m > lane.length_m - to_goal;
  });
  RandomWorld drawn = world_to_cross(lane, random);
  drawn.passage_m = std::min(*drawn.passage_m, 2.0 * std::min(to_start, to_goal));
  drawn.legs.front().reverse = random.below(4) == 0;
  return drawn;
}

RandomWorld draw_slanted_gates(table::RandomStream& random) {
  SidedLane lane = walled_lane(random.uniform(3.4, 4.6), random.uniform(0.8, 1.2));
  double along = kLaneEnd + kFirst;
  while (along <= lane.length_m - kLaneEnd - kFirst) {
    const double width = std::min(draw_gate_width(random), lane.width_m - 0.1);
    add_gate(lane,
             {{along, random.uniform(-0.06, 0.06)}, random.uniform(-0.9, 0.9)},
             width,
             random.uniform(0.10, 0.25));
    along += random.uniform(0.9, 1.6);
  }
  return world_to_cross(lane, random);
}

// Two jaws, one behind the other, that may reach past each other. They are drawn again until a body
// could pass between them, or nearly.
RandomWorld draw_staggered(table::RandomStream& random) {
  SidedLane lane = walled_lane(random.uniform(3.8, 4.4), random.uniform(0.95, 1.4));
  const bool left_first = random.below(2) == 0;
  const double body = corpus_robot().body_width_m;
  const double end = 0.5 * lane.width_m - 0.03;
  Polygon left;
  Polygon right;
  for (double gap = 0.0; gap < body - 0.02 || gap > body + 0.3;) {
    const double thickness = random.uniform(0.10, 0.20);
    const double along = random.uniform(kLaneEnd + kFirst, kLaneEnd + kFirst + 0.2);
    const double behind = along + random.uniform(0.1, 0.75);
    const double middle = random.uniform(-0.1, 0.1);
    const double apart = random.uniform(-0.25, 0.7);
    const double left_edge = std::clamp(middle + 0.5 * apart, -end, end);
    const double right_edge = std::clamp(middle - 0.5 * apart, -end, end);
    const double left_from = left_first ? along : behind;
    const double right_from = left_first ? behind : along;
    left = jaw(lane, left_from, left_from + thickness, left_edge, true);
    right = jaw(lane, right_from, right_from + thickness, right_edge, false);
    gap = region_gap(left, right);
    const double shift = std::max(behind - along - thickness, 0.0);
    // Square to what lies between the two corners that are nearest to each other.
    const Point ahead{std::max(left_edge - right_edge, 0.0), left_first ? shift : -shift};
    lane.way = {{{0.5 * (along + thickness + behind), 0.5 * (left_edge + right_edge)},
                 elementary::atan2(ahead.y_m, ahead.x_m)}};
  }
  lane.left.push_back(left);
  lane.right.push_back(right);
  return world_to_cross(lane, random);
}

// One or two rows of a single post, with eight sides; the run takes the wider gap of each, or now
// and then the other one.
RandomWorld draw_posts(table::RandomStream& random) {
  SidedLane lane = walled_lane(random.uniform(3.4, 4.4), random.uniform(1.05, 1.5));
  const double body = corpus_robot().body_width_m;
  double passage = lane.width_m;
  double along = kLaneEnd + kFirst;
  while (along <= lane.length_m - kLaneEnd - kFirst) {
    const double radius = random.uniform(0.06, 0.12);
    const double both = lane.width_m - 2.0 * radius;
    const double wide =
        random.uniform(std::max(body - 0.02, 0.5 * both), std::min(body + 0.3, both - 0.01));
    const double side = random.below(2) == 0 ? 1.0 : -1.0;
    const double y = side * (0.5 * lane.width_m - wide - radius);
    Polygon post;
    for (int i = 0; i < 8; ++i) {
      post.vertices.push_back(Point{along, y} + radius * direction(0.25 * std::numbers::pi * i));
    }
    lane.posts.push_back(post);
    passage = std::min(passage, std::max(wide, both - wide));
    const bool other = both - wide > body + 0.02 && random.below(5) == 0;
    const double gap = other ? both - wide : wide;
    lane.way.push_back({{along, (other ? -side : side) * 0.5 * (lane.width_m - gap)}, 0.0});
    along += random.uniform(1.0, 1.6);
  }
  RandomWorld drawn = world_to_cross(lane, random);
  drawn.passage_m = passage;
  return drawn;
}

// A bay in one wall, into which the run looks before it backs out and goes on.
RandomWorld draw_dead_ends(table::RandomStream& random) {
  SidedLane lane = walled_lane(random.uniform(5.0, 5.6), random.uniform(0.85, 1.2));
  const double side = random.below(2) == 0 ? 1.0 : -1.0;
  const double mouth = random.uniform(0.8, 1.1);
  const double depth = random.uniform(0.35, 1.2);
  const double from = random.uniform(1.6, 1.9);
  const double wall = 0.5 * lane.width_m;
  const double bottom = wall + depth;
  std::vector<Polygon>& bay = side > 0.0 ? lane.left : lane.right;
  const auto block = [&](double from_m, double to_m, double near_m, double far_m) {
    return side > 0.0 ? box({from_m, near_m}, {to_m, far_m})
                      : box({from_m, -far_m}, {to_m, -near_m});
  };
  bay = {wall_of(lane, 0.0, from, side > 0.0),
         wall_of(lane, from + mouth, lane.length_m, side > 0.0),
         block(from - kWallThickness, from, wall, bottom + kWallThickness),
         block(from + mouth, from + mouth + kWallThickness, wall, bottom + kWallThickness),
         block(from, from + mouth, bottom, bottom + kWallThickness)};
  if (random.below(2) == 0) {
    const double width = std::min(draw_gate_width(random), lane.width_m - 0.1);
    add_gate(lane, {{from + mouth + 0.75, random.uniform(-0.05, 0.05)}, 0.0}, width, 0.15);
  }
  const Pose frame = draw_frame(random);
  RandomWorld drawn = world_of(lane, frame);
  const Pose before{{from - 0.35, 0.0}, 0.0};
  const double in = wall + std::max(depth - 0.5 * corpus_robot().body_width_m - 0.02, 0.05);
  const Pose inside{{from + 0.5 * mouth, side * in}, side * 0.5 * std::numbers::pi};
  std::vector<Point> out = moved(path_through({before, inside}), frame);
  std::reverse(out.begin(), out.end());
  std::vector<Pose> on{before};
  on.insert(on.end(), lane.way.begin(), lane.way.end());
  on.push_back(end_of(lane));
  drawn.legs = {{moved(path_through({{lane.start.centre, 0.0}, before, inside}), frame), false},
                {out, true},
                {moved(path_through(on), frame), false}};
  return drawn;
}

// A lane of straights that meet in corners; its walls meet in corners, too.
RandomWorld draw_kinks(table::RandomStream& random) {
  const double width = random.uniform(0.7, 1.1);
  const std::uint32_t corners = 1 + random.below(3);
  std::vector<Point> centre{{0.0, 0.0}};
  std::vector<double> heading{draw_frame(random).yaw_rad};
  double side = random.below(2) == 0 ? 1.0 : -1.0;
  for (std::uint32_t i = 0; i <= corners; ++i) {
    const bool is_end = i == 0 || i == corners;
    centre.push_back(centre.back() +
                     random.uniform(is_end ? 1.4 : 1.0, 1.7) * direction(heading.back()));
    heading.push_back(heading.back() + side * random.uniform(0.35, 1.2));
    side = -side;
  }
  RandomWorld drawn;
  for (const double left : {1.0, -1.0}) {
    Polygon wall;
    for (const double across : {0.5 * width, 0.5 * width + kWallThickness}) {
      std::vector<Point> line;
      for (std::size_t i = 0; i < centre.size(); ++i) {
        const double before = heading[i == 0 ? 0 : i - 1];
        const double after = heading[std::min<std::size_t>(i, corners)];
        const Point square = direction(0.5 * (before + after) + 0.5 * std::numbers::pi);
        line.push_back(centre[i] +
                       left * across / elementary::cos(0.5 * (after - before)) * square);
      }
      if (across > 0.5 * width) {
        std::reverse(line.begin(), line.end());
      }
      wall.vertices.insert(wall.vertices.end(), line.begin(), line.end());
    }
    drawn.world.obstacles.emplace_back(wall);
  }
  const double far = 0.5 * width + kWallThickness;
  const Pose first{centre.front(), heading.front()};
  const Pose last{centre.back(), heading[corners]};
  drawn.world.obstacles.emplace_back(box_at(first, {-kWallThickness, -far}, {0.0, far}));
  drawn.world.obstacles.emplace_back(box_at(last, {0.0, -far}, {kWallThickness, far}));
  const double radius = std::min(kRandomRegionRadius, 0.5 * width - 0.005);
  const Point start = transform(first, {kLaneEnd, 0.0});
  const Point goal = transform(last, {-kLaneEnd, 0.0});
  drawn.world.start = Disc{start, radius};
  drawn.world.goal = Disc{goal, radius};
  drawn.world.bounds = bounds_of(drawn.world, 0.1);
  drawn.passage_m = width;
  std::vector<Pose> way{{start, heading.front()}};
  for (std::size_t i = 1; i < corners; ++i) {
    way.push_back({0.5 * (centre[i] + centre[i + 1]), heading[i]});
  }
  way.push_back({transform(last, {kIntoGoal - kLaneEnd, 0.0}), heading[corners]});
  drawn.legs = {{path_through(way), false}};
  return drawn;
}

}  // namespace tcert
