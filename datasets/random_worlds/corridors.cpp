#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "datasets/corpus/tentacles.hpp"
#include "datasets/random_worlds/families.hpp"
#include "datasets/random_worlds/walled_lane.hpp"
#include "datasets/worlds/region_distance.hpp"

namespace tcert {
namespace {

constexpr double kStart = 0.6;       // of S's middle from the lane's end, and of G's from the other
constexpr double kFirstGate = 0.75;  // from S's middle, and the last one's from G's
constexpr double kBetweenGates = 0.55;

void draw_lane_gates(WalledLane& lane, std::uint32_t most, table::RandomStream& random) {
  const double last = length_of(lane) - kStart - kFirstGate;
  const std::uint32_t count = random.below(most + 1);
  double along = kStart + kFirstGate;
  for (std::uint32_t i = 0; i < count; ++i) {
    along += random.uniform(0.0, 0.5);
    if (along > last) {
      return;
    }
    LaneGate gate;
    gate.along_m = along;
    gate.width_m = std::min(draw_gate_width(random), lane.width_m - 0.1);
    const double room = 0.5 * (lane.width_m - gate.width_m);
    gate.offset_m = random.uniform(-1.0, 1.0) * std::min(0.12, room);
    gate.length_m = random.uniform(0.10, 0.30);
    lane.gates.push_back(gate);
    along += kBetweenGates;
  }
}

/// In a bend a jaw may be nearer to the wall across than to the other jaw. The obstacles are the
/// left and the right wall, two caps, and a left and a right jaw a gate.
double beside_jaws(const World& world, std::size_t gates) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < gates; ++i) {
    const std::size_t left = 4 + 2 * i;
    least = std::min({least,
                      region_gap(world.obstacles[left], world.obstacles[1]),
                      region_gap(world.obstacles[left + 1], world.obstacles[0])});
  }
  return least;
}

RandomWorld corridor_world(const WalledLane& lane, table::RandomStream& random) {
  RandomWorld drawn;
  const double goal = length_of(lane) - kStart;
  const double region = std::min(kRandomRegionRadius, 0.5 * lane.width_m - 0.005);
  drawn.world.start = Disc{pose_at(lane, kStart).position, region};
  drawn.world.goal = Disc{pose_at(lane, goal).position, region};
  add_walls(drawn.world, lane);
  add_caps(drawn.world, lane);
  add_gates(drawn.world, lane);
  drawn.world.bounds = bounds_of(drawn.world, 0.1);
  drawn.passage_m = std::min(passage_of(lane), beside_jaws(drawn.world, lane.gates.size()));

  double from = kStart;
  const std::uint32_t turns = random.uniform() < 0.3 ? 1 + random.below(3) : 0;
  for (std::uint32_t i = 0; i < turns; ++i) {
    const double forth = from + random.uniform(0.2, goal - from - 0.1);
    const double back = std::max(kStart, forth - random.uniform(0.05, 0.8));
    drawn.legs.push_back({path_along(lane, from, forth), false});
    drawn.legs.push_back({path_along(lane, forth, back), true});
    from = back;
    if (goal - from < 0.5) {
      break;
    }
  }
  drawn.legs.push_back({path_along(lane, from, goal + kIntoGoal), false});
  return drawn;
}

}  // namespace

double draw_gate_width(table::RandomStream& random) {
  return corpus_robot().body_width_m +
         (random.uniform() < 0.05 ? random.uniform(-0.02, 0.004) : random.uniform(0.004, 0.25));
}

RandomWorld draw_gates(table::RandomStream& random) {
  WalledLane lane;
  lane.begin = {{0.0, 0.0}, random.uniform(-std::numbers::pi, std::numbers::pi)};
  lane.pieces = {{random.uniform(3.0, 4.2), 0.0}};
  lane.width_m = random.uniform(0.75, 1.2);
  draw_lane_gates(lane, 3, random);
  return corridor_world(lane, random);
}

// The heading stays within 80 degrees of the first, so the lane never meets itself.
RandomWorld draw_bends(table::RandomStream& random) {
  constexpr double kMostTurn = 80.0 * std::numbers::pi / 180.0;
  WalledLane lane;
  lane.begin = {{0.0, 0.0}, random.uniform(-std::numbers::pi, std::numbers::pi)};
  lane.width_m = random.uniform(0.65, 1.1);
  lane.pieces.push_back({random.uniform(1.0, 1.3), 0.0});
  double heading = 0.0;
  for (std::uint32_t i = 0, count = 1 + random.below(3); i < count; ++i) {
    const double least = 0.5 * lane.width_m + kWallThickness + 0.05;
    const double radius = random.uniform(least, least + 1.0);
    const double side =
        heading == 0.0 ? (random.below(2) == 0 ? 1.0 : -1.0) : std::copysign(1.0, -heading);
    const double to = side * random.uniform(0.2, kMostTurn);
    lane.pieces.push_back({radius * std::abs(to - heading), side / radius});
    heading = to;
    if (random.below(2) == 0) {
      lane.pieces.push_back({random.uniform(0.2, 0.8), 0.0});
    }
  }
  lane.pieces.push_back({random.uniform(1.0, 1.3), 0.0});
  draw_lane_gates(lane, 2, random);
  return corridor_world(lane, random);
}

// As tight as the wall inside of the bend lets it be.
RandomWorld draw_s_bends(table::RandomStream& random) {
  WalledLane lane;
  lane.begin = {{0.0, 0.0}, random.uniform(-std::numbers::pi, std::numbers::pi)};
  lane.width_m = random.uniform(0.55, 0.85);
  const double side = random.below(2) == 0 ? 1.0 : -1.0;
  const double least = 0.5 * lane.width_m + kWallThickness + 0.05;
  const double turn = random.uniform(0.7, 1.4);
  lane.pieces.push_back({random.uniform(1.0, 1.3), 0.0});
  for (const double one : {side, -side}) {
    const double radius = least + random.uniform(0.0, 0.2);
    lane.pieces.push_back({radius * turn, one / radius});
  }
  lane.pieces.push_back({random.uniform(1.0, 1.3), 0.0});
  draw_lane_gates(lane, 1, random);
  return corridor_world(lane, random);
}

// Two straights joined by a half turn about the end of the wall, half of them too narrow for the
// turning limit. The end room is longer than the corridors are wide, so that only the outer walls
// limit the turn.
RandomWorld draw_u_turn(table::RandomStream& random) {
  RandomWorld drawn;
  drawn.corridor_m =
      random.below(2) == 0 ? random.uniform(0.465, 0.60) : random.uniform(0.60, 0.95);
  drawn.wall_m = random.uniform(0.10, 0.12);
  drawn.passage_m = drawn.corridor_m;
  const double length = random.uniform(2.2, 2.8);  // of the thin wall; it ends at x = 0
  const double room = drawn.corridor_m + 0.3;
  const double outer = drawn.corridor_m + 0.5 * drawn.wall_m;
  const double half_wall = 0.5 * drawn.wall_m;
  const Pose origin;
  const double low = -length - kWallThickness;
  const double high = room + kWallThickness;
  const double side = outer + kWallThickness;
  auto& obstacles = drawn.world.obstacles;
  obstacles = {box_at(origin, {-length, -half_wall}, {0.0, half_wall}),
               box_at(origin, {low, outer}, {high, side}),
               box_at(origin, {low, -side}, {high, -outer}),
               box_at(origin, {low, -side}, {-length, side}),
               box_at(origin, {room, -side}, {high, side})};
  drawn.world.bounds = bounds_of(drawn.world, 0.1);

  // S and G are discs that leave no way round the thin wall and fit their corridors.
  const double region = std::min(kRandomRegionRadius, 0.5 * drawn.corridor_m - 0.005);
  const double slack = 0.5 * drawn.corridor_m - 0.5 * corpus_robot().body_width_m - 0.002;
  const double middle = half_wall + 0.5 * drawn.corridor_m;
  const double lane = middle + random.uniform(-1.0, 1.0) * std::max(slack, 0.0);
  const double far = -length + 0.7;
  drawn.world.start = Disc{{far, -middle}, region};
  drawn.world.goal = Disc{{far, middle}, region};
  std::vector<Point> path = straight_path({far, -lane}, {0.0, -lane});
  const auto steps = static_cast<int>(std::ceil(std::numbers::pi * lane / kPathStep));
  for (int i = 1; i < steps; ++i) {
    path.push_back(lane * direction(std::numbers::pi * (static_cast<double>(i) / steps - 0.5)));
  }
  const std::vector<Point> home = straight_path({0.0, lane}, {far - 0.15, lane});
  path.insert(path.end(), home.begin(), home.end());
  drawn.legs = {{path, false}};
  return drawn;
}

}  // namespace tcert
