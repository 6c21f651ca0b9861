#include <algorithm>
#include <numbers>
#include <tcert/elementary.hpp>

#include "datasets/corpus/trial_course.hpp"
#include "datasets/random_worlds/families.hpp"
#include "datasets/random_worlds/walled_lane.hpp"

namespace tcert {
namespace {

constexpr int kLaneGates = 2;
constexpr double kRounding = 3e-4;  // how much wider rounded vertices may make a gate

double lane_passage(const TrialCourse& trial, Lane lane) {
  double least = trial.course.lane_width_m;
  for (const Gate& gate : trial.gates) {
    if (gate.lane == lane) {
      least = std::min(least, gate.width_m);
    }
  }
  return least;
}

void append_after_first(std::vector<Point>& path, const std::vector<Point>& more) {
  path.insert(path.end(), more.begin() + 1, more.end());
}

// The ring's inside and the island are regular polygons that face each other side by side: the
// distance between their sides, and so the widest disc that gets round, is exactly the lane's
// width.
constexpr int kSides = 72;

/// A corner of the regular polygon whose sides touch the circle of `radius`.
Point corner_about(double radius, int i) {
  return radius / elementary::cos(std::numbers::pi / kSides) *
         direction(2.0 * std::numbers::pi * i / kSides);
}

/// A wall of quadrilaterals round a circle, which they touch.
void add_ring(World& world, double radius) {
  const double outer = radius + kWallThickness;
  for (int i = 0; i < kSides; ++i) {
    world.obstacles.emplace_back(Polygon{{corner_about(radius, i),
                                          corner_about(outer, i),
                                          corner_about(outer, i + 1),
                                          corner_about(radius, i + 1)}});
  }
}

void add_island(World& world, double radius) {
  Polygon island;
  for (int i = 0; i < kSides; ++i) {
    island.vertices.push_back(corner_about(radius, i));
  }
  world.obstacles.emplace_back(std::move(island));
}

/// Half of the ring, from S's middle at angle pi to G's at 0: below if `side` is +1.
WalledLane half_ring(double radius, double width, double side) {
  WalledLane lane;
  lane.begin = {{-radius, 0.0}, -side * 0.5 * std::numbers::pi};
  lane.pieces = {{std::numbers::pi * radius, side / radius}};
  lane.width_m = width;
  return lane;
}

}  // namespace

// S lies at angle pi of the ring, G at 0.
RandomWorld draw_loop(table::RandomStream& random) {
  const double radius = random.uniform(0.9, 1.3);
  const double width = random.uniform(0.7, 1.0);
  std::array<WalledLane, 2> halves{half_ring(radius, width, 1.0), half_ring(radius, width, -1.0)};
  RandomWorld drawn;
  for (WalledLane& half : halves) {
    for (int i = 0; i < kLaneGates; ++i) {
      if (random.uniform() < 0.3) {
        continue;
      }
      LaneGate gate;
      gate.along_m =
          length_of(half) * (i == 0 ? random.uniform(0.27, 0.40) : random.uniform(0.6, 0.73));
      gate.width_m = std::min(draw_gate_width(random), width - 0.1);
      gate.offset_m = random.uniform(-1.0, 1.0) * std::min(0.08, 0.5 * (width - gate.width_m));
      gate.length_m = random.uniform(0.10, 0.25);
      half.gates.push_back(gate);
    }
    add_gates(drawn.world, half);
  }
  add_ring(drawn.world, radius + 0.5 * width);
  add_island(drawn.world, radius - 0.5 * width);
  drawn.world.bounds = bounds_of(drawn.world, 0.1);
  const double region = std::min(kRandomRegionRadius, 0.5 * width - 0.01);
  drawn.world.start = Disc{{-radius, 0.0}, region};
  drawn.world.goal = Disc{{radius, 0.0}, region};
  drawn.passage_m = std::max(passage_of(halves[0]), passage_of(halves[1]));

  const std::uint32_t first = random.below(2);
  const std::vector<Point> there = path_along(halves[first], 0.0, length_of(halves[first]));
  const std::vector<Point> back = path_along(halves[1 - first], length_of(halves[1 - first]), 0.0);
  const std::uint32_t laps = random.below(4) == 0 ? 0 : 2 + random.below(2);
  std::vector<Point> path = there;
  for (std::uint32_t lap = 0; lap < laps; ++lap) {
    append_after_first(path, back);
    append_after_first(path, there);
  }
  append_after_first(path,
                     path_along(halves[1 - first],
                                length_of(halves[1 - first]),
                                length_of(halves[1 - first]) - kIntoGoal));
  drawn.legs = {{path, false}};
  drawn.lanes = 2;
  drawn.explored = laps == 0 ? 1 : 2;
  return drawn;
}

// From S to G and back by the other two lanes, as often as drawn; or once, with a look into the
// lane that is not taken.
RandomWorld draw_figure_eight(table::RandomStream& random) {
  TrialCourse trial;
  trial.course = {random.uniform(0.7, 1.0), random.uniform(1.0, 1.2)};
  RandomWorld drawn;
  double passage = trial.course.lane_width_m;
  for (const bool at_goal : {false, true}) {
    double widest = 0.0;
    for (const bool upper : {false, true}) {
      const double end = walled_length(trial.course) - 0.15;
      double along = random.uniform(0.7, 0.9);
      while (along < end) {
        Gate gate;
        gate.lane = {at_goal, upper};
        gate.along_m = along;
        gate.offset_m = random.uniform(-0.03, 0.03);
        gate.width_m = draw_gate_width(random);
        gate.length_m = random.uniform(0.10, 0.20);
        if (random.uniform() < 0.6) {
          trial.gates.push_back(gate);
        }
        along += random.uniform(0.55, 0.8);
      }
      widest = std::max(widest, lane_passage(trial, {at_goal, upper}));
    }
    passage = std::min(passage, widest);
  }
  drawn.world = build_world(trial.course, trial.gates);
  drawn.passage_m = passage + kRounding;
  drawn.lanes = 4;

  trial.route = {{false, random.below(2) == 0}, {true, random.below(2) == 0}};
  const std::uint32_t passes = 1 + random.below(5);
  if (passes == 1) {
    drawn.legs = plan_legs(trial, random.below(2) == 0, random.uniform(0.5, 1.0));
    drawn.explored = 2;
    return drawn;
  }
  TrialCourse other = trial;
  other.route = {{false, !trial.route.first.upper}, {true, !trial.route.second.upper}};
  const std::vector<Point> there = plan_legs(trial, false, 0.0).front().path;
  std::vector<Point> back = plan_legs(other, false, 0.0).front().path;
  std::reverse(back.begin(), back.end());
  std::vector<Point> path = there;
  for (std::uint32_t pass = 1; pass < passes; ++pass) {
    append_after_first(path, pass % 2 == 1 ? back : there);
  }
  drawn.legs = {{path, false}};
  drawn.explored = 4;
  return drawn;
}

}  // namespace tcert
